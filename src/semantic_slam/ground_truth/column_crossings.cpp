#include "semantic_slam/ground_truth/column_crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace semantic_slam {
namespace {

using Corners = std::array<Eigen::Vector3d, 3>;

// On which side of the directed line from a to b the point is, seen from above: left +1, right -1.
// Points on the line count to one side of it, the same for a to b and for b to a.
int SideOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector2d& p) {
  // Both directions compute with the same numbers, so that their rounding agrees.
  const bool swapped = std::tie(b.x(), b.y()) < std::tie(a.x(), a.y());
  const Eigen::Vector3d &from = swapped ? b : a, &to = swapped ? a : b;
  const double left =
      (to.x() - from.x()) * (p.y() - from.y()) - (to.y() - from.y()) * (p.x() - from.x());
  return (left >= 0.0) != swapped ? 1 : -1;
}

bool IsInside(const Corners& corners, const Eigen::Vector2d& p) {
  const int side = SideOf(corners[0], corners[1], p);
  return SideOf(corners[1], corners[2], p) == side && SideOf(corners[2], corners[0], p) == side;
}

// The first cell whose centre is at or above a coordinate.
int FirstCentre(double coordinate_m, double origin_m, double resolution_m) {
  return static_cast<int>(std::ceil((coordinate_m - origin_m) / resolution_m - 0.5));
}

void CrossTriangle(const Corners& corners, const CellLattice& lattice,
                   std::vector<Crossing>& crossings) {
  const Eigen::Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (normal.z() == 0.0) return;
  const Eigen::Array3d low = corners[0].array().min(corners[1].array()).min(corners[2].array());
  const Eigen::Array3d high = corners[0].array().max(corners[1].array()).max(corners[2].array());
  const double step = lattice.resolution_m;
  const Eigen::Vector2d& origin = lattice.origin_m;
  const int last_x = FirstCentre(high.x(), origin.x(), step);
  const int last_y = FirstCentre(high.y(), origin.y(), step);
  for (int y = FirstCentre(low.y(), origin.y(), step); y <= last_y; ++y) {
    for (int x = FirstCentre(low.x(), origin.x(), step); x <= last_x; ++x) {
      const Eigen::Vector2d p = origin + step * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (!IsInside(corners, p)) continue;
      const Eigen::Vector2d away = p - corners[0].head<2>();
      const double z = corners[0].z() - normal.head<2>().dot(away) / normal.z();
      crossings.push_back({{x, y}, z, normal.z() > 0.0});
    }
  }
}

// Where a line leaves one solid and enters another at the same height, it leaves first.
bool ComesBefore(const Crossing& a, const Crossing& b) {
  return std::make_tuple(a.cell.y, a.cell.x, a.z_m, !a.faces_up) <
         std::make_tuple(b.cell.y, b.cell.x, b.z_m, !b.faces_up);
}

}  // namespace

std::vector<Crossing> CrossColumns(const Mesh& mesh, const Rigid3d& T_world_mesh,
                                   const CellLattice& lattice) {
  std::vector<Crossing> crossings;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Corners corners;
    for (int i = 0; i < 3; ++i) corners[i] = T_world_mesh * mesh.positions_m[t[i]].cast<double>();
    CrossTriangle(corners, lattice, crossings);
  }
  std::stable_sort(crossings.begin(), crossings.end(), ComesBefore);
  return crossings;
}

std::vector<SolidPart> SolidParts(const std::vector<Crossing>& crossings) {
  std::vector<SolidPart> parts;
  int depth = 0;  // solids that the line is inside of
  double entered_m = 0.0;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Crossing& crossing = crossings[i];
    if (i > 0 && crossings[i - 1].cell != crossing.cell) depth = 0;
    if (!crossing.faces_up) {
      if (depth++ == 0) entered_m = crossing.z_m;
    } else if (depth > 0 && --depth == 0) {
      parts.push_back({crossing.cell, entered_m, crossing.z_m});
    }
  }
  return parts;
}

}  // namespace semantic_slam
