#pragma once

#include "semantic_slam/common/transform.h"
#include "semantic_slam/localization/visual_localization.h"

namespace semantic_slam {

constexpr double kNewMapAfterS = 0.3;

// For SmallCamera()'s pictures of the small room, 15 of them per second.
inline LocalizationOptions RoomOptions() {
  LocalizationOptions options;
  options.features.max_features = 500;
  options.tracking.max_keyframe_gap = 3;
  options.tracking.new_map_after_s = kNewMapAfterS;
  return options;
}

// In the middle of the small room, looking along `yaw_rad`, a little to the side.
inline Rigid3d Looking(double yaw_rad, double aside_m = 0.0) {
  Rigid3d T_body_camera = Rigid3d::Identity();
  T_body_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return Eigen::Translation3d(0.0, aside_m, 1.3) *
         Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) * T_body_camera;
}

}  // namespace semantic_slam
