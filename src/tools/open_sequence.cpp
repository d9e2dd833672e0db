#include "tools/open_sequence.h"

#include <filesystem>
#include <utility>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "semantic_slam_ros/bag_source.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<RgbdSource> OpenFolder(const std::string& folder, const CameraConfig& config,
                                       Trajectory& ground_truth) {
  auto source = std::make_unique<TumFolder>(folder, config);
  const fs::path path = fs::path(folder) / "groundtruth.txt";
  if (fs::exists(path)) ground_truth = ReadTumTrajectory(path);
  return source;
}

std::unique_ptr<RgbdSource> OpenBag(const std::string& path, Trajectory& ground_truth) {
  auto bag = std::make_unique<semantic_slam_ros::BagSource>(path);
  ground_truth = bag->ground_truth();
  return bag;
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
  auto source = fs::is_directory(dataset) ? OpenFolder(dataset, config, sequence.ground_truth)
                                          : OpenBag(dataset, sequence.ground_truth);
  sequence.R_camera_imu = source->R_camera_imu().value_or(config.R_camera_imu);
  sequence.source = std::make_unique<PrefetchingSource>(std::move(source));
  return sequence;
}

}  // namespace semantic_slam
