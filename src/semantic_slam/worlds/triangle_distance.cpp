#include "semantic_slam/worlds/triangle_distance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

// Distance from p to the segment from a to b.
double DistanceToSegment(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + share * along - p).norm();
}

}  // namespace

double DistanceToTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const auto is_inside = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return normal.dot((to - from).cross(p - from)) >= 0.0;
  };
  if (normal.norm() > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
    return std::abs(normal.dot(p - a)) / normal.norm();
  }
  return std::min(
      {DistanceToSegment(p, a, b), DistanceToSegment(p, b, c), DistanceToSegment(p, c, a)});
}

}  // namespace semantic_slam
