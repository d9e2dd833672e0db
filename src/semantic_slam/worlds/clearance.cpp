#include "semantic_slam/worlds/clearance.h"

#include <algorithm>
#include <limits>

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

// Distance from p to the triangle of the corners a, b, c: to its plane if p is above or below it,
// else to the nearest edge.
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

double DistanceToMesh(const Eigen::Vector3d& p, const Mesh& mesh) {
  double nearest_m = std::numeric_limits<double>::infinity();
  const auto corner = [&mesh](int index) -> Eigen::Vector3d {
    return mesh.positions_m[index].cast<double>();
  };
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    nearest_m = std::min(nearest_m, DistanceToTriangle(p, corner(triangle[0]), corner(triangle[1]),
                                                       corner(triangle[2])));
  }
  return nearest_m;
}

Eigen::AlignedBox3d BoundsOf(const WorldObject& object) {
  Eigen::AlignedBox3d bounds;
  for (const Surface& surface : object.surfaces) {
    for (const Eigen::Vector3f& position : surface.mesh.positions_m) {
      bounds.extend(position.cast<double>());
    }
  }
  return bounds;
}

}  // namespace

Clearance::Clearance(const World& world) : world_(world) {
  for (const WorldObject& object : world.objects) bounds_m_.push_back(BoundsOf(object));
}

NearestSurface Clearance::At(const Eigen::Vector3d& position_m, double time_s) const {
  NearestSurface nearest{std::numeric_limits<double>::infinity(), kNoInstance};
  for (std::size_t i = 0; i < world_.objects.size(); ++i) {
    const WorldObject& object = world_.objects[i];
    const Eigen::Vector3d p_object = object.Pose(time_s).inverse() * position_m;
    if (bounds_m_[i].isEmpty() || bounds_m_[i].exteriorDistance(p_object) >= nearest.distance_m) {
      continue;
    }
    for (const Surface& surface : object.surfaces) {
      const double distance_m = DistanceToMesh(p_object, surface.mesh);
      if (distance_m < nearest.distance_m) nearest = {distance_m, object.instance};
    }
  }
  return nearest;
}

}  // namespace semantic_slam
