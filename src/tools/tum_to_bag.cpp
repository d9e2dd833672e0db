#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "semantic_slam/common/check.h"
#include "semantic_slam_ros/tum_bag.h"
#include "tools/command_line.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Writes a folder in the format of the TUM RGB-D benchmark as a bag with the topics and frames\n"
    "of the published TUM bags.";

using semantic_slam_ros::PublishedTumCamera;
using semantic_slam_ros::TumBagOptions;
using semantic_slam_ros::TumBagReport;

// A folder may bring its calibration with it.
CameraConfig ChooseCamera(const std::string& folder, const std::string& config) {
  const std::filesystem::path own = std::filesystem::path(folder) / "camera.yaml";
  if (!config.empty()) return LoadCameraConfig(config);
  return std::filesystem::exists(own) ? LoadCameraConfig(own.string()) : PublishedTumCamera();
}

void Print(const TumBagReport& report, const std::string& bag) {
  std::cout << bag << ": " << report.colour << " colour and " << report.depth << " depth images, "
            << report.poses << " poses, " << report.accelerometer << " accelerometer readings\n";
  if (report.dropped == 0) return;
  std::cerr << report.dropped << " images left out:\n";
  for (const std::string& problem : report.problems) std::cerr << "  " << problem << "\n";
}

int TumToBag(CommandLine& command_line) {
  std::string folder, bag, config;
  TumBagOptions options;
  command_line.Argument("DIR", &folder, "the TUM folder");
  command_line.Argument("OUT.bag", &bag, "the bag to write");
  command_line.Option("config", "FILE", &config,
                      "calibration, size of a depth unit and axes of the accelerometer, such as "
                      "config/tum_freiburg1.yaml; else DIR/camera.yaml; else what the published "
                      "bags have: the driver's default, without distortion");
  command_line.Option("start", "S", &options.start_s, "begin S seconds after the first image");
  command_line.Option("duration", "S", &options.duration_s, "write S seconds only");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  CheckInRange("--start", options.start_s, 0.0, 1e6);
  CheckInRange("--duration", options.duration_s.value_or(1.0), 1e-3, 1e6);
  options.camera = ChooseCamera(folder, config);
  std::optional<ProgressBar> progress;
  const auto show_progress = [&](std::size_t done, std::size_t all) {
    if (!progress) progress.emplace("writing", all);
    progress->Update(done);
  };
  const TumBagReport report = semantic_slam_ros::WriteTumBag(folder, bag, options, show_progress);
  progress.reset();  // ends its line
  Print(report, bag);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::TumToBag);
}
