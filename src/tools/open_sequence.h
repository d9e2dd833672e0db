#pragma once

#include <functional>
#include <memory>
#include <string>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/dataset/prefetching_source.h"
#include "semantic_slam/evaluation/trajectory.h"

namespace semantic_slam {

// A recorded sequence with everything that is known about it.
struct Sequence {
  std::unique_ptr<PrefetchingSource> source;
  CameraIntrinsics camera;
  Eigen::Matrix3d R_camera_imu = Eigen::Matrix3d::Identity();
  Trajectory ground_truth;  // of the colour optical frame; empty if there is none
};

// Opens a TUM folder or a bag, and reads the camera from the configuration file; `read_options` reads
// the file's other groups. Throws ConfigError or InputError, one line that names the file.
Sequence OpenSequence(const std::string& dataset, const std::string& config_path,
                      const std::function<void(YamlReader&)>& read_options);

}  // namespace semantic_slam
