#include "semantic_slam/ground_truth/surface_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "semantic_slam/worlds/triangle_distance.h"

namespace semantic_slam {
namespace {

constexpr double kCubeM = 0.1;
constexpr double kHalfDiagonalM = 0.5 * 1.7321 * kCubeM;
constexpr double kEndM = 0.01;  // of a line of sight, at which a surface is no obstacle

}  // namespace

SurfaceLabels::SurfaceLabels(const World& world) {
  for (const WorldObject& object : world.objects) {
    if (object.IsMoving()) continue;
    const Eigen::Isometry3f T_world_object = object.T_world_object.cast<float>();
    for (const Surface& surface : object.surfaces) {
      for (const Eigen::Vector3i& t : surface.mesh.triangles) {
        const auto corner = [&](int i) -> Eigen::Vector3f {
          return T_world_object * surface.mesh.positions_m[t[i]];
        };
        Add({corner(0), corner(1), corner(2), object.label, object.instance});
      }
    }
  }
}

std::vector<NearbySurface> SurfaceLabels::Around(const Eigen::Vector3d& point,
                                                 double reach_m) const {
  std::array<double, 256> nearest;
  nearest.fill(std::numeric_limits<double>::infinity());
  const Cube low = CubeOf(point.array() - reach_m), high = CubeOf(point.array() + reach_m);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) {
        const auto found = cubes_.find(KeyOf({x, y, z}));
        if (found == cubes_.end()) continue;
        for (const std::uint32_t i : found->second) {
          const double distance_m = Distance(triangles_[i], point);
          if (distance_m <= reach_m) {
            nearest[triangles_[i].label] = std::min(nearest[triangles_[i].label], distance_m);
          }
        }
      }
    }
  }
  std::vector<NearbySurface> surfaces;
  for (std::size_t label = 0; label < nearest.size(); ++label) {
    if (nearest[label] > reach_m) continue;
    surfaces.push_back({static_cast<LabelId>(label), nearest[label]});
  }
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [](const auto& a, const auto& b) { return a.distance_m < b.distance_m; });
  return surfaces;
}

// Walks in steps that are shorter than a cube. From one cube to the next the line may cut the
// corners of those beside both, so these are looked into as well.
bool SurfaceLabels::IsBlocked(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                              InstanceId ignored) const {
  const Eigen::Vector3d way = to - from;
  const int steps = static_cast<int>(std::ceil(way.norm() / kCubeM)) + 1;
  Cube last = CubeOf(from);
  for (int i = 0; i <= steps; ++i) {
    const Cube cube = CubeOf(from + static_cast<double>(i) / steps * way);
    if (i > 0 && cube == last) continue;
    const Cube low = cube.cwiseMin(last), high = cube.cwiseMax(last);
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        for (int x = low.x(); x <= high.x(); ++x) {
          if (IsBlockedInCube({x, y, z}, from, to, ignored)) return true;
        }
      }
    }
    last = cube;
  }
  return false;
}

SurfaceLabels::Cube SurfaceLabels::CubeOf(const Eigen::Vector3d& point) {
  return (point / kCubeM).array().floor().cast<int>();
}

// 21 bits for each coordinate: 100 km to every side.
std::uint64_t SurfaceLabels::KeyOf(const Cube& cube) {
  constexpr std::uint64_t kMask = (1u << 21) - 1;
  const auto bits = [](int i) { return static_cast<std::uint64_t>(i) & kMask; };
  return bits(cube.x()) << 42 | bits(cube.y()) << 21 | bits(cube.z());
}

double SurfaceLabels::Distance(const Triangle& triangle, const Eigen::Vector3d& point) {
  return DistanceToTriangle(point, triangle.a.cast<double>(), triangle.b.cast<double>(),
                            triangle.c.cast<double>());
}

void SurfaceLabels::Add(const Triangle& triangle) {
  const auto index = static_cast<std::uint32_t>(triangles_.size());
  triangles_.push_back(triangle);
  const Eigen::Vector3f lowest = triangle.a.cwiseMin(triangle.b).cwiseMin(triangle.c);
  const Eigen::Vector3f highest = triangle.a.cwiseMax(triangle.b).cwiseMax(triangle.c);
  const Cube low = CubeOf(lowest.cast<double>()), high = CubeOf(highest.cast<double>());
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int x = low.x(); x <= high.x(); ++x) {
        const Eigen::Vector3d centre = kCubeM * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
        if (Distance(triangle, centre) > kHalfDiagonalM) continue;
        cubes_[KeyOf({x, y, z})].push_back(index);
      }
    }
  }
}

// Moeller and Trumbore, Journal of Graphics Tools 1997.
bool SurfaceLabels::IsBlockedInCube(const Cube& cube, const Eigen::Vector3d& from,
                                    const Eigen::Vector3d& to, InstanceId ignored) const {
  const auto found = cubes_.find(KeyOf(cube));
  if (found == cubes_.end()) return false;
  const Eigen::Vector3d way = to - from;
  const double end = kEndM / std::max(way.norm(), kEndM);
  for (const std::uint32_t i : found->second) {
    const Triangle& triangle = triangles_[i];
    if (triangle.instance == ignored && ignored != kNoInstance) continue;
    const Eigen::Vector3d a = triangle.a.cast<double>();
    const Eigen::Vector3d ab = triangle.b.cast<double>() - a, ac = triangle.c.cast<double>() - a;
    const Eigen::Vector3d across = way.cross(ac);
    const double determinant = ab.dot(across);
    if (determinant == 0.0) continue;
    const Eigen::Vector3d away = from - a;
    const double u = away.dot(across) / determinant;
    const Eigen::Vector3d q = away.cross(ab);
    const double v = way.dot(q) / determinant;
    const double t = ac.dot(q) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > end && t < 1.0 - end) return true;
  }
  return false;
}

}  // namespace semantic_slam
