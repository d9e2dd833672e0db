#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

inline Eigen::AlignedBox3f BoundsOf(const Mesh& mesh) {
  Eigen::AlignedBox3f bounds;
  for (const Eigen::Vector3f& p : mesh.positions_m) bounds.extend(p);
  return bounds;
}

// Positive if the triangles of a closed mesh are counter-clockwise as seen from outside (divergence
// theorem).
inline double VolumeOf(const Mesh& mesh) {
  double volume = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d a = mesh.positions_m[t[0]].cast<double>();
    const Eigen::Vector3d b = mesh.positions_m[t[1]].cast<double>();
    const Eigen::Vector3d c = mesh.positions_m[t[2]].cast<double>();
    volume += a.dot(b.cross(c)) / 6.0;
  }
  return volume;
}

// Numbers the places where corners of a mesh are; corners within 20 um share theirs.
inline std::vector<int> PlacesOf(const Mesh& mesh) {
  constexpr float kCellM = 1e-4f;
  constexpr float kSameM = 2e-5f;
  std::map<std::array<long, 3>, std::vector<std::pair<Eigen::Vector3f, int>>> cells;
  std::vector<int> places;
  int count = 0;
  for (const Eigen::Vector3f& p : mesh.positions_m) {
    int place = -1;
    std::array<long, 3> cell;
    for (int i = 0; i < 3; ++i) cell[i] = std::lround(p[i] / kCellM);
    for (int neighbour = 0; neighbour < 27 && place < 0; ++neighbour) {
      const auto near = cells.find({cell[0] + neighbour % 3 - 1, cell[1] + neighbour / 3 % 3 - 1,
                                    cell[2] + neighbour / 9 - 1});
      if (near == cells.end()) continue;
      for (const auto& [at, number] : near->second) {
        if ((at - p).norm() < kSameM) place = number;
      }
    }
    if (place < 0) {
      place = count++;
      cells[cell].emplace_back(p, place);
    }
    places.push_back(place);
  }
  return places;
}

// What is wrong with a mesh that should be closed: an edge without its counterpart in the other
// direction. "" if nothing is.
inline std::string OpenEdgeOf(const Mesh& mesh) {
  const std::vector<int> places = PlacesOf(mesh);
  std::map<std::pair<int, int>, std::pair<int, int>> balance;  // and a corner, to say where
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const int from = places[t[i]];
      const int to = places[t[(i + 1) % 3]];
      if (from == to) return "an edge without length";
      auto& [count, corner] = balance[std::minmax(from, to)];
      count += from < to ? 1 : -1;
      corner = t[i];
    }
  }
  for (const auto& [edge, balanced] : balance) {
    if (balanced.first == 0) continue;
    std::ostringstream text;
    text << "an open edge at " << mesh.positions_m[balanced.second].transpose();
    return text.str();
  }
  return "";
}

// What is wrong with the arrays of a mesh; "" if nothing is: each corner has a unit normal and a
// place on the texture, each triangle three corners that exist and lies on the outer side that its
// normals say.
inline std::string FaultOf(const Mesh& mesh) {
  const std::size_t corners = mesh.positions_m.size();
  if (mesh.normals.size() != corners || mesh.texture_m.size() != corners) return "array sizes";
  for (std::size_t i = 0; i < corners; ++i) {
    if (!mesh.positions_m[i].allFinite() || !mesh.texture_m[i].allFinite()) return "not finite";
    if (std::abs(mesh.normals[i].norm() - 1.0f) > 1e-4f) return "a normal's length";
  }
  for (const Eigen::Vector3i& t : mesh.triangles) {
    if (t.minCoeff() < 0 || t.maxCoeff() >= static_cast<int>(corners)) return "an index";
    const Eigen::Vector3f& a = mesh.positions_m[t[0]];
    const Eigen::Vector3f face =
        (mesh.positions_m[t[1]] - a).cross(mesh.positions_m[t[2]] - a).normalized();
    for (int i = 0; i < 3; ++i) {
      if (face.dot(mesh.normals[t[i]]) < 0.0f) return "a triangle wound against its normals";
    }
  }
  return "";
}

}  // namespace semantic_slam
