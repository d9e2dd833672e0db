#include "semantic_slam/ground_truth/object_visibility.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "semantic_slam/common/throttle.h"
#include "semantic_slam/ground_truth/surface_points.h"

namespace semantic_slam {
namespace {

constexpr double kPointsPerObject = 40.0;  // about

double SurfaceArea(const WorldObject& object) {
  double area_m2 = 0.0;
  for (const Surface& surface : object.surfaces) {
    for (const Eigen::Vector3i& t : surface.mesh.triangles) {
      const Eigen::Vector3f& a = surface.mesh.positions_m[t[0]];
      area_m2 +=
          0.5 *
          (surface.mesh.positions_m[t[1]] - a).cross(surface.mesh.positions_m[t[2]] - a).norm();
    }
  }
  return area_m2;
}

// The middles of small patches of about equal size, in the world: every point that stands for so
// much of the surface.
std::vector<Eigen::Vector3d> SpreadOver(const WorldObject& object) {
  const double patch_m2 = SurfaceArea(object) / kPointsPerObject;
  std::vector<Eigen::Vector3d> points;
  double carried_m2 = 0.5 * patch_m2;  // surface that no point stands for yet
  for (const Surface& surface : object.surfaces) {
    for (const Eigen::Vector3i& t : surface.mesh.triangles) {
      const Eigen::Vector3d a =
          object.T_world_object * surface.mesh.positions_m[t[0]].cast<double>();
      const Eigen::Vector3d b =
          object.T_world_object * surface.mesh.positions_m[t[1]].cast<double>();
      const Eigen::Vector3d c =
          object.T_world_object * surface.mesh.positions_m[t[2]].cast<double>();
      const double area_m2 = 0.5 * (b - a).cross(c - a).norm();
      const int count = static_cast<int>((carried_m2 + area_m2) / patch_m2);
      carried_m2 += area_m2 - count * patch_m2;
      for (int i = 0; i < count; ++i) {
        // Along the line from one corner through the triangle, by shares of its area.
        const double far = std::sqrt((i + 0.5) / count), side = std::fmod((i + 1) * 0.618034, 1.0);
        points.push_back(a + far * ((1.0 - side) * (b - a) + side * (c - a)));
      }
    }
  }
  return points;
}

class Viewer {
 public:
  Viewer(const SurfaceLabels& surfaces, const CameraModel& camera, const VisibilityOptions& options)
      : surfaces_(surfaces), camera_(camera), options_(options) {}

  bool Sees(const std::vector<Eigen::Vector3d>& points, InstanceId instance,
            const Rigid3d& T_world_camera) const {
    const Rigid3d T_camera_world = T_world_camera.inverse();
    const double needed = options_.min_share * static_cast<double>(points.size());
    std::size_t seen = 0, left = points.size();
    for (const Eigen::Vector3d& point : points) {
      if (static_cast<double>(seen + left--) < needed) return false;
      if (!IsInImage(T_camera_world * point)) continue;
      if (!surfaces_.IsBlocked(T_world_camera.translation(), point, instance)) ++seen;
    }
    return seen > 0 && static_cast<double>(seen) >= needed;
  }

 private:
  bool IsInImage(const Eigen::Vector3d& p_camera) const {
    if (!(p_camera.z() >= options_.min_depth_m && p_camera.z() <= options_.max_depth_m)) {
      return false;
    }
    const Eigen::Vector2d pixel = camera_.Project(p_camera);
    return pixel.x() >= 0.0 && pixel.y() >= 0.0 && pixel.x() <= camera_.width_px() - 1.0 &&
           pixel.y() <= camera_.height_px() - 1.0;
  }

  const SurfaceLabels& surfaces_;
  const CameraModel& camera_;
  const VisibilityOptions& options_;
};

std::vector<Rigid3d> SparsePoses(const Trajectory& trajectory, double period_s) {
  std::vector<Rigid3d> poses;
  Throttle throttle(period_s);
  for (const StampedPose& stamped : trajectory) {
    if (throttle.IsDue(stamped.stamp)) poses.push_back(stamped.pose);
  }
  return poses;
}

}  // namespace

std::vector<int> CountViews(const World& world, const SurfaceLabels& surfaces,
                            const Trajectory& T_world_camera, const CameraModel& camera,
                            const VisibilityOptions& options) {
  Validate(options);
  const std::vector<Rigid3d> poses = SparsePoses(T_world_camera, options.period_s);
  const Viewer viewer(surfaces, camera, options);
  std::vector<int> views;
  for (const WorldObject& object : world.objects) {
    views.push_back(0);
    if (object.IsMoving()) continue;
    const std::vector<Eigen::Vector3d> points = SpreadOver(object);
    for (const Rigid3d& pose : poses) {
      if (viewer.Sees(points, object.instance, pose)) ++views.back();
    }
  }
  return views;
}

}  // namespace semantic_slam
