#include "tools/open_sequence.h"

#include <filesystem>
#include <utility>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/prefetching_source.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "semantic_slam_ros/bag_source.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

void OpenFolder(const std::string& folder, const CameraConfig& config, Sequence& sequence) {
  sequence.source = std::make_unique<TumFolder>(folder, config);
  const fs::path ground_truth = fs::path(folder) / "groundtruth.txt";
  if (fs::exists(ground_truth)) sequence.ground_truth = ReadTumTrajectory(ground_truth);
}

void OpenBag(const std::string& path, Sequence& sequence) {
  auto bag = std::make_unique<semantic_slam_ros::BagSource>(path);
  sequence.ground_truth = bag->ground_truth();
  sequence.source = std::move(bag);
}

}  // namespace

Sequence OpenSequence(const std::string& dataset, const std::string& config_path,
                      const std::function<void(YamlReader&)>& read_options) {
  YamlReader file(LoadYamlMap(config_path), config_path);
  const CameraConfig config = ReadCameraConfig(file);
  read_options(file);
  file.Finish();
  Sequence sequence;
  sequence.camera = config.intrinsics;
  if (!fs::exists(dataset)) throw InputError("no such file or folder: " + dataset);
  if (fs::is_directory(dataset)) {
    OpenFolder(dataset, config, sequence);
  } else {
    OpenBag(dataset, sequence);
  }
  sequence.R_camera_imu = sequence.source->R_camera_imu().value_or(config.R_camera_imu);
  sequence.source = std::make_unique<PrefetchingSource>(std::move(sequence.source));
  return sequence;
}

}  // namespace semantic_slam
