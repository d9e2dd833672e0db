#include "semantic_slam/worlds/clearance.h"

#include <algorithm>
#include <limits>

#include "semantic_slam/worlds/triangle_distance.h"

namespace semantic_slam {
namespace {

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
