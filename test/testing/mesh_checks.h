#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>

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

// What is wrong with a mesh that should be closed: an edge without its counterpart in the other
// direction. Corners within 10 um are the same. "" if nothing is.
inline std::string OpenEdgeOf(const Mesh& mesh) {
  using Key = std::array<long, 3>;
  const auto key = [](const Eigen::Vector3f& p) {
    return Key{std::lround(p.x() * 1e5), std::lround(p.y() * 1e5), std::lround(p.z() * 1e5)};
  };
  std::map<std::pair<Key, Key>, int> balance;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Key from = key(mesh.positions_m[t[i]]);
      const Key to = key(mesh.positions_m[t[(i + 1) % 3]]);
      if (from == to) return "an edge without length";
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  for (const auto& [edge, count] : balance) {
    if (count == 0) continue;
    return "an open edge at " + std::to_string(edge.first[0] * 1e-5) + " " +
           std::to_string(edge.first[1] * 1e-5) + " " + std::to_string(edge.first[2] * 1e-5);
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
