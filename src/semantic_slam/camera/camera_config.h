#pragma once

#include <string>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/yaml_options.h"

namespace semantic_slam {

// What config/<camera>.yaml says of one sensor.
struct CameraConfig {
  CameraIntrinsics intrinsics;
  // Rotation from the accelerometer's axes to the colour optical frame. Only data that comes
  // without tf (a TUM folder) needs it.
  Eigen::Matrix3d R_camera_imu = Eigen::Matrix3d::Identity();
  // Units of the dataset's 16-bit depth PNG files: depth [m] = value / factor. TUM: 5000.
  double depth_png_factor = 5000.0;
};

// Reads the groups "camera", "imu" and "dataset" of a configuration file and leaves its other groups
// to the caller's reader. Throws ConfigError naming file, line and key.
CameraConfig ReadCameraConfig(YamlReader& file);

// The same from a file that may hold other components' groups too; those are not looked at.
CameraConfig LoadCameraConfig(const std::string& path);

}  // namespace semantic_slam
