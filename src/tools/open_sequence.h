#pragma once

#include <memory>
#include <string>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/dataset/rgbd_source.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/localization/visual_localization.h"

namespace semantic_slam {

// A recorded sequence with everything that is known about it.
struct Sequence {
  std::unique_ptr<RgbdSource> source;  // reads ahead on its own thread
  CameraIntrinsics camera;
  Eigen::Matrix3d R_camera_imu = Eigen::Matrix3d::Identity();
  Trajectory ground_truth;  // of the colour optical frame; empty if there is none
};

// Opens a TUM folder or a bag, and reads camera and options from the configuration file. Throws
// ConfigError or InputError, one line that names the file.
Sequence OpenSequence(const std::string& dataset, const std::string& config_path,
                      LocalizationOptions& options);

}  // namespace semantic_slam
