#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"

// A camera's level frame: its origin is the camera's, z points up and x to where the camera looks,
// seen from above (to where the image's upper edge points, if the camera looks straight up or
// down).

namespace semantic_slam {

// R_level_camera. `up_camera` points up in the camera's optical frame and has length 1.
Eigen::Matrix3d LevelFromCamera(const Eigen::Vector3d& up_camera);

// T_map_level, in a map with z up.
Rigid3d LevelPose(const Rigid3d& T_map_camera);

}  // namespace semantic_slam
