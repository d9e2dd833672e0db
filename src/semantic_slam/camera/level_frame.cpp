#include "semantic_slam/camera/level_frame.h"

namespace semantic_slam {
namespace {

constexpr double kMinForward = 1e-3;  // sine of the view's angle to the vertical

}  // namespace

Eigen::Matrix3d LevelFromCamera(const Eigen::Vector3d& up_camera) {
  Eigen::Vector3d forward = Eigen::Vector3d::UnitZ() - up_camera.z() * up_camera;
  if (forward.norm() < kMinForward) {
    forward = -Eigen::Vector3d::UnitY() + up_camera.y() * up_camera;
  }
  forward.normalize();
  Eigen::Matrix3d R_level_camera;
  R_level_camera.row(0) = forward;
  R_level_camera.row(1) = up_camera.cross(forward);
  R_level_camera.row(2) = up_camera;
  return R_level_camera;
}

Rigid3d LevelPose(const Rigid3d& T_map_camera) {
  const Eigen::Vector3d up_camera = T_map_camera.linear().row(2).normalized();
  Rigid3d T_map_level = T_map_camera;
  T_map_level.linear() = T_map_camera.linear() * LevelFromCamera(up_camera).transpose();
  return T_map_level;
}

}  // namespace semantic_slam
