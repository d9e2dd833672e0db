#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "semantic_slam/common/transform.h"
#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {

// Points all over a triangle, its edges too, at most `spacing_m` apart: visit(point).
template <typename Visit>
void ForEachTrianglePoint(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                          const Eigen::Vector3d& c, double spacing_m, Visit&& visit) {
  const Eigen::Vector3d along = b - a, up = c - a;
  const int rows = std::max(1, static_cast<int>(std::ceil(up.norm() / spacing_m)));
  for (int row = 0; row <= rows; ++row) {
    const double height = static_cast<double>(row) / rows;
    const Eigen::Vector3d width = (1.0 - height) * along;
    const int steps = std::max(1, static_cast<int>(std::ceil(width.norm() / spacing_m)));
    for (int i = 0; i <= steps; ++i) {
      visit(Eigen::Vector3d(a + height * up + (static_cast<double>(i) / steps) * width));
    }
  }
}

// Points all over a mesh in the world, at most `spacing_m` apart: visit(point). They are a hair
// inside of their solid, a millimetre below its faces and a thousandth of a triangle's size away
// from its edges, so that where a solid ends at the border of a cell they are in its own cell.
template <typename Visit>
void ForEachSurfacePoint(const Mesh& mesh, const Rigid3d& T_world_mesh, double spacing_m,
                         Visit&& visit) {
  constexpr double kBelowM = 1e-3, kAsideShare = 1e-3;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    const Eigen::Vector3d a = T_world_mesh * mesh.positions_m[t[0]].cast<double>();
    const Eigen::Vector3d b = T_world_mesh * mesh.positions_m[t[1]].cast<double>();
    const Eigen::Vector3d c = T_world_mesh * mesh.positions_m[t[2]].cast<double>();
    const Eigen::Vector3d below = -kBelowM * (b - a).cross(c - a).normalized();
    const auto inside = [&, middle = Eigen::Vector3d((a + b + c) / 3.0)](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(p + kAsideShare * (middle - p) + below);
    };
    ForEachTrianglePoint(inside(a), inside(b), inside(c), spacing_m, visit);
  }
}

}  // namespace semantic_slam
