// Renders a flight through a simulated world as a recorded sequence with all truth.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/check.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "semantic_slam/ground_truth/truth_files.h"
#include "semantic_slam/simulation/camera_path.h"
#include "semantic_slam/simulation/rendered_sequence_writer.h"
#include "semantic_slam/simulation/simulated_camera.h"
#include "semantic_slam/simulation/visible_boxes.h"
#include "semantic_slam/worlds/world_file.h"
#include "semantic_slam_ros/tum_bag.h"
#include "tools/background_writer.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

namespace fs = std::filesystem;

constexpr char kPurpose[] =
    "Renders what the drone's camera sees on its way through a simulated world and writes it to "
    "OUT:\n"
    "a folder in the format of the TUM RGB-D benchmark with the truth beside it (labels, "
    "instances,\n"
    "boxes, objects, floor plans, imu), or, if OUT ends in .bag, a bag as tum_to_bag writes it. "
    "The\n"
    "same seed gives the same bytes.";

constexpr Stamp kStart{100'000'000'000};  // of a tour

struct Arguments {
  std::string world;
  std::string trajectory;
  std::string out;
  std::string labels;
  std::string camera;
  std::string simulator;
  std::string noise = "on";
  int rate_hz = 30;
  int seed = 1;
  int truth_period = 1;
  double duration_s = 0.0;
};

// nullopt after printing the help.
std::optional<Arguments> ParseArguments(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("WORLD", &arguments.world,
                        "world file, or the name of one in config/worlds");
  command_line.Argument(
      "TRAJECTORY", &arguments.trajectory,
      "tour (.yaml, or the name of one in config/tours), which the drone flies, or "
      "poses of the camera's optical frame in TUM's format");
  command_line.Argument("OUT", &arguments.out, "folder or .bag");
  command_line.Option("rate", "HZ", &arguments.rate_hz, "images per second");
  command_line.Option("noise", "on|off", &arguments.noise, "of colour, depth and imu");
  command_line.Option("seed", "N", &arguments.seed, "of the noise");
  command_line.Option("truth-period", "N", &arguments.truth_period,
                      "write labels, instances and boxes of every Nth image");
  command_line.Option("duration", "S", &arguments.duration_s, "end after S seconds; 0: at the end");
  command_line.Option("camera", "CAMERA.yaml", &arguments.camera,
                      "default: config/simulated_d455.yaml");
  command_line.Option("simulator", "SIMULATOR.yaml", &arguments.simulator,
                      "drone and noise; default: config/simulator.yaml");
  command_line.Option("labels", "LABELS.yaml", &arguments.labels,
                      "the vocabulary; default: config/labels.yaml");
  if (!command_line.Parse()) return std::nullopt;
  CheckInRange("--rate", arguments.rate_hz, 1, 300);
  CheckInRange("--seed", arguments.seed, 0, 1000000);
  CheckInRange("--truth-period", arguments.truth_period, 1, 1000000);
  CheckInRange("--duration", arguments.duration_s, 0.0, 86400.0);
  if (arguments.noise != "on" && arguments.noise != "off") {
    throw ConfigError("--noise = " + arguments.noise + ", expected on or off");
  }
  return arguments;
}

struct RenderOptions {
  SimulatedFlightOptions flight;
  SimulatedCameraOptions camera;
  VisibleBoxesOptions boxes;
};

// The file is simulator_node's; what else is in it concerns that alone.
RenderOptions ReadOptions(const Arguments& arguments) {
  const std::string path = ConfigFile(arguments.simulator, "simulator.yaml");
  YamlReader reader(LoadYamlMap(path), path);
  RenderOptions options;
  ReadOptionGroups(reader, options.flight);
  ReadOptionGroups(reader, options.camera);
  reader.ReadOptions("visible_boxes", options.boxes);
  options.flight.mount.image_rate_hz = arguments.rate_hz;
  const bool noise = arguments.noise == "on";
  options.flight.imu.noise = options.camera.depth_noise.noise = noise;
  options.camera.colour_noise.noise = noise;
  options.flight.imu.seed = options.camera.depth_noise.seed = arguments.seed;
  options.camera.colour_noise.seed = arguments.seed;
  return options;
}

bool IsTour(const std::string& trajectory) {
  return fs::path(trajectory).extension() == ".yaml" || !fs::is_regular_file(trajectory);
}

CameraPath MakePath(const Arguments& arguments, const RenderOptions& options) {
  CameraPath path;
  if (IsTour(arguments.trajectory)) {
    const Tour tour = LoadTour(FindInConfig(arguments.trajectory, "tours"));
    path = FlyTour(tour, options.flight, kStart);
  } else {
    path = FollowTrajectory(ReadTumTrajectory(arguments.trajectory), arguments.rate_hz,
                            options.flight.mount.imu_rate_hz, options.flight.imu);
  }
  if (path.T_world_camera.empty()) throw ConfigError(arguments.trajectory + " has no waypoints");
  return path;
}

// Leaves out what is later than `duration_s` after the start.
void Shorten(double duration_s, CameraPath& path) {
  if (duration_s == 0.0) return;
  const Stamp start = path.T_world_camera.front().stamp;
  const auto is_later = [&](const auto& item) {
    return SecondsBetween(start, item.stamp) > duration_s;
  };
  const auto cut = [&](auto& items) {
    items.erase(std::find_if(items.begin(), items.end(), is_later), items.end());
  };
  cut(path.T_world_camera);
  cut(path.readings);
}

void RenderImages(const SimulatedCamera& camera, const CameraPath& path, BackgroundWriter& writer) {
  ProgressBar progress("rendering", path.T_world_camera.size());
  const Stamp start = path.T_world_camera.front().stamp;
  std::size_t done = 0;
  for (const StampedPose& stamped : path.T_world_camera) {
    const double time_s = SecondsBetween(start, stamped.stamp);
    writer.Push(camera.Capture(stamped.pose, stamped.stamp, time_s), stamped.pose, time_s);
    progress.Update(++done);
  }
  writer.Finish();
}

void CopyText(const std::string& from, const fs::path& to) {
  std::ifstream file(from);
  WriteFileAtomically(to, [&file](std::ostream& out) { out << file.rdbuf(); });
}

void Render(const Arguments& arguments, const CameraConfig& config, const std::string& folder) {
  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(ConfigFile(arguments.labels, "labels.yaml"));
  const RenderOptions options = ReadOptions(arguments);
  const std::string world_path = FindInConfig(arguments.world, "worlds");
  const auto world = std::make_shared<const World>(LoadWorld(world_path, vocabulary));
  CameraPath path = MakePath(arguments, options);
  Shorten(arguments.duration_s, path);
  const VisibleBoxes boxes(options.boxes, world, vocabulary);
  const SimulatedCamera camera(std::make_shared<const SceneRenderer>(world), config.intrinsics,
                               options.camera);
  RenderedSequenceWriter writer(folder, config, vocabulary, *world, arguments.truth_period);
  CopyText(world_path, fs::path(folder) / "world.yaml");
  WriteTruthFiles(folder, *world, vocabulary, path.T_world_camera);
  BackgroundWriter background(writer, boxes, camera.model());
  RenderImages(camera, path, background);
  writer.Finish(path);
  std::cout << arguments.out << ": " << path.T_world_camera.size() << " images, "
            << path.readings.size() << " imu readings\n";
}

// By way of a folder beside it.
void RenderBag(const Arguments& arguments, const CameraConfig& config) {
  const std::string folder = arguments.out + ".folder";
  Render(arguments, config, folder);
  semantic_slam_ros::TumBagOptions options;
  options.camera = config;
  semantic_slam_ros::WriteTumBag(folder, arguments.out, options);
  fs::remove_all(folder);
}

int RenderSequence(CommandLine& command_line) {
  const std::optional<Arguments> arguments = ParseArguments(command_line);
  if (!arguments) return EXIT_SUCCESS;
  const CameraConfig config =
      LoadCameraConfig(ConfigFile(arguments->camera, "simulated_d455.yaml"));
  if (fs::path(arguments->out).extension() == ".bag") {
    RenderBag(*arguments, config);
  } else if (IsTumFolder(arguments->out)) {
    throw ConfigError(arguments->out +
                      " holds a sequence already: remove it, or name another folder");
  } else {
    Render(*arguments, config, arguments->out);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose,
                                   semantic_slam::RenderSequence);
}
