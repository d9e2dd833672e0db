#include "semantic_slam/simulation/mesh_parts.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

constexpr int kMaxRefinements = 6;  // each halves edges

Eigen::Vector3f AreaVector(const Mesh& mesh, const Eigen::Vector3i& triangle) {
  const Eigen::Vector3f& a = mesh.positions_m[triangle[0]];
  return (mesh.positions_m[triangle[1]] - a).cross(mesh.positions_m[triangle[2]] - a);
}

bool CanBeDrawn(const Mesh& mesh, const Eigen::Vector3i& triangle) {
  const auto count = static_cast<int>(
      std::min({mesh.positions_m.size(), mesh.normals.size(), mesh.texture_m.size()}));
  for (int i = 0; i < 3; ++i) {
    if (triangle[i] < 0 || triangle[i] >= count) return false;
    if (!mesh.positions_m[triangle[i]].allFinite() || !mesh.normals[triangle[i]].allFinite() ||
        !mesh.texture_m[triangle[i]].allFinite()) {
      return false;
    }
  }
  return AreaVector(mesh, triangle).norm() > 1e-10f;  // [m^2]
}

// Disjoint sets of corners.
class CornerSets {
 public:
  explicit CornerSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int Root(int corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void Join(int a, int b) { parent_[Root(b)] = Root(a); }

 private:
  std::vector<int> parent_;
};

// Puts a triangle of `mesh` into one of its parts, whose corners so far `corner_in_part` knows.
void AddTriangle(const Mesh& mesh, const Eigen::Vector3i& triangle,
                 std::vector<int>& corner_in_part, Mesh& part) {
  Eigen::Vector3i in_part;
  for (int i = 0; i < 3; ++i) {
    int& corner = corner_in_part[triangle[i]];
    if (corner < 0) {
      corner = static_cast<int>(part.positions_m.size());
      part.positions_m.push_back(mesh.positions_m[triangle[i]]);
      part.normals.push_back(mesh.normals[triangle[i]]);
      part.texture_m.push_back(mesh.texture_m[triangle[i]]);
    }
    in_part[i] = corner;
  }
  part.triangles.push_back(in_part);
}

// Halves the long edges of all triangles of a part, once.
class EdgeHalver {
 public:
  EdgeHalver(Mesh& part, float max_edge_m) : part_(part), max_edge_m_(max_edge_m) {}

  // Returns false if there was nothing to halve.
  bool Run() {
    std::vector<Eigen::Vector3i> coarse;
    coarse.swap(part_.triangles);
    for (const Eigen::Vector3i& triangle : coarse) Split(triangle);
    return !middles_.empty();
  }

 private:
  // The corner in the middle of an edge; -1 if the edge is short.
  int Middle(int a, int b) {
    if ((part_.positions_m[a] - part_.positions_m[b]).norm() <= max_edge_m_) return -1;
    const auto [place, is_new] =
        middles_.try_emplace(std::minmax(a, b), static_cast<int>(part_.positions_m.size()));
    if (is_new) {
      part_.positions_m.push_back(0.5f * (part_.positions_m[a] + part_.positions_m[b]));
      part_.normals.push_back((part_.normals[a] + part_.normals[b]).normalized());
      part_.texture_m.push_back(0.5f * (part_.texture_m[a] + part_.texture_m[b]));
    }
    return place->second;
  }

  // Goes round the triangle, starting so that the cases differ in the number of halved edges only.
  void Split(const Eigen::Vector3i& t) {
    const std::array<int, 3> m{Middle(t[0], t[1]), Middle(t[1], t[2]), Middle(t[2], t[0])};
    const auto halved = std::count_if(m.begin(), m.end(), [](int middle) { return middle >= 0; });
    int first = 0;
    if (halved == 1) {
      while (m[first] < 0) ++first;
    } else if (halved == 2) {
      while (m[(first + 2) % 3] >= 0) ++first;
    }
    const int a = t[first], b = t[(first + 1) % 3], c = t[(first + 2) % 3];
    const int ab = m[first], bc = m[(first + 1) % 3], ca = m[(first + 2) % 3];
    auto& out = part_.triangles;
    if (halved == 0) out.push_back(t);
    if (halved == 1) out.insert(out.end(), {{a, ab, c}, {ab, b, c}});
    if (halved == 2) out.insert(out.end(), {{a, ab, c}, {ab, bc, c}, {ab, b, bc}});
    if (halved == 3) out.insert(out.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }

  Mesh& part_;
  const float max_edge_m_;
  std::map<std::pair<int, int>, int> middles_;
};

}  // namespace

std::vector<Mesh> ConnectedParts(const Mesh& mesh) {
  CornerSets sets(mesh.positions_m.size());
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    if (!CanBeDrawn(mesh, triangle)) continue;
    sets.Join(triangle[0], triangle[1]);
    sets.Join(triangle[0], triangle[2]);
  }
  std::vector<Mesh> parts;
  std::vector<int> part_of_root(mesh.positions_m.size(), -1);
  std::vector<int> corner_in_part(mesh.positions_m.size(), -1);
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    if (!CanBeDrawn(mesh, triangle)) continue;
    int& part = part_of_root[sets.Root(triangle[0])];
    if (part < 0) {
      part = static_cast<int>(parts.size());
      parts.emplace_back();
    }
    AddTriangle(mesh, triangle, corner_in_part, parts[part]);
  }
  return parts;
}

bool IsFlat(const Mesh& part) {
  const Eigen::Vector3f normal = AreaVector(part, part.triangles.front()).normalized();
  const Eigen::Vector3f& on_plane = part.positions_m.front();
  for (std::size_t i = 0; i < part.positions_m.size(); ++i) {
    if (std::abs(normal.dot(part.positions_m[i] - on_plane)) > 1e-4f) return false;  // [m]
    if (part.normals[i].dot(normal) < 0.999f) return false;
  }
  return true;
}

Mesh Refined(Mesh part, float max_edge_m) {
  for (int i = 0; i < kMaxRefinements && EdgeHalver(part, max_edge_m).Run(); ++i) {
  }
  return part;
}

}  // namespace semantic_slam
