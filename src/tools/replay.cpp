// Runs the cores on a recorded sequence, without a ROS master.

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam/localization/gravity_alignment.h"
#include "semantic_slam/localization/run_report.h"
#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam/localization/visual_localization.h"
#include "tools/command_line.h"
#include "tools/open_sequence.h"
#include "tools/progress_bar.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Localizes a recorded RGB-D sequence and leaves in OUT: trajectory.txt, trajectory_live.txt,\n"
    "keyframe_trajectory.txt (TUM's format, colour optical frame in the map, z up), trajectory.png,\n"
    "timing.csv and summary.json. As fast as it can, and with the same bytes on every run (but for\n"
    "timing.csv); or, with --realtime, at the sensor's rate, dropping images that come too late.";

struct Arguments {
  std::string dataset;
  std::string config;
  std::string out;
  std::string stages = "tracking";
  bool realtime = false;
};

// Refuses what this program cannot do yet, by name.
void CheckStages(const std::string& stages) {
  std::istringstream list(stages);
  bool tracking = false;
  for (std::string stage; std::getline(list, stage, ',');) {
    if (stage == "tracking") {
      tracking = true;
    } else if (stage == "semantic" || stage == "objects" || stage == "grid") {
      throw ConfigError("--stages: stage '" + stage + "' is not available in this version, only tracking is");
    } else {
      throw ConfigError("--stages: unknown stage '" + stage + "', expected tracking, semantic, objects or grid");
    }
  }
  if (!tracking) throw ConfigError("--stages: tracking is missing; every other stage needs its poses");
}

std::optional<Arguments> ParseArguments(CommandLine& command_line) {
  Arguments arguments;
  std::optional<std::string> segmentation, detection;
  command_line.RequiredOption("dataset", "DIR|FILE.bag", &arguments.dataset,
                              "a folder in TUM's format or a bag");
  command_line.RequiredOption("config", "CAMERA.yaml", &arguments.config,
                              "camera and options: config/tum_freiburg1.yaml, ...");
  command_line.RequiredOption("out", "OUT", &arguments.out, "folder for the results");
  command_line.Option("stages", "LIST", &arguments.stages, "stages to run, separated by commas");
  command_line.Option("segmentation", "CARD.yaml", &segmentation,
                      "network for the stage 'semantic' (not available in this version)");
  command_line.Option("detection", "CARD.yaml", &detection,
                      "network for the stage 'objects' (not available in this version)");
  command_line.Flag("realtime", &arguments.realtime,
                    "play at the sensor's rate and drop images that come too late");
  if (!command_line.Parse()) return std::nullopt;
  if (segmentation) throw ConfigError("--segmentation: the stage 'semantic' is not available in this version");
  if (detection) throw ConfigError("--detection: the stage 'objects' is not available in this version");
  CheckStages(arguments.stages);
  return arguments;
}

// Sets the map's z axis up. Returns where "up" came from.
std::string AlignWithGravity(const Sequence& sequence, const RgbdImage& first,
                             const CameraModel& camera, VisualLocalization& localization) {
  // The camera is the robot: z forward, x right, y down is what x forward, y left, z up sees.
  Rigid3d T_base_camera = Rigid3d::Identity();
  T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  std::optional<Eigen::Vector3d> up_camera;
  if (const auto mean = MeanAcceleration(sequence.source->accelerometer(), first.stamp)) {
    up_camera = sequence.R_camera_imu * *mean;
  }
  const MapStart start = FindMapStart(up_camera, first, camera, T_base_camera);
  localization.SetStart(start.T_map_camera);
  return start.source;
}

// Everything a run needs, and what it finds out.
struct Run {
  Sequence& sequence;
  const CameraModel& camera;
  VisualLocalization& localization;
  TrajectoryRecorder recorder;
  RunFacts facts;

  void Track(const RgbdImage& image) try {
    if (facts.gravity.empty()) facts.gravity = AlignWithGravity(sequence, image, camera, localization);
    recorder.Add(localization.Track(image));
  } catch (const InputError& e) {
    ++facts.dropped["malformed"];
    std::cerr << "dropped image at " << ToString(image.stamp) << " s: " << e.what() << '\n';
  }

  std::string Note() const { return recorder.lost() == 0 ? "" : std::to_string(recorder.lost()) + " lost"; }
};

void RunAsFastAsPossible(Run& run) {
  ProgressBar progress("tracking", run.sequence.source->size());
  std::size_t done = 0;
  while (const auto image = run.sequence.source->Next()) {
    run.Track(*image);
    progress.Update(++done, run.Note());
  }
}

// The sensor does not wait: an image that finds two others waiting pushes the older one out.
void RunAtSensorRate(Run& run) {
  ProgressBar progress("tracking", run.sequence.source->size());
  std::optional<Worker<RgbdImage>> worker;
  worker.emplace(2, WhenFull::kDropOldest, [&](const RgbdImage& image) { run.Track(image); });
  const auto start = std::chrono::steady_clock::now();
  std::optional<Stamp> first;
  std::size_t done = 0;
  while (const auto image = run.sequence.source->Next()) {
    if (!first) first = image->stamp;
    // Waiting for the sensor's clock is what this mode is for.
    std::this_thread::sleep_until(start + std::chrono::nanoseconds(image->stamp.ns - first->ns));
    worker->Push(*image);
    progress.Update(++done);
  }
  run.facts.dropped["late"] = worker->dropped();
  worker.reset();  // works off what is left
}

int Replay(CommandLine& command_line) {
  const auto arguments = ParseArguments(command_line);
  if (!arguments) return EXIT_SUCCESS;
  LocalizationOptions options;
  Sequence sequence = OpenSequence(arguments->dataset, arguments->config, options);
  const auto camera = std::make_shared<const CameraModel>(sequence.camera);
  VisualLocalization localization(options, camera, arguments->realtime ? MappingMode::kThreaded : MappingMode::kInline);
  Run run{sequence, *camera, localization, {}, {}};
  run.facts.source = arguments->dataset;
  run.facts.timings_in_summary = arguments->realtime;
  if (arguments->realtime) {
    RunAtSensorRate(run);
  } else {
    RunAsFastAsPossible(run);
  }
  localization.Finish();
  if (sequence.source->dropped() > 0) run.facts.dropped["unreadable"] = sequence.source->dropped();
  for (const std::string& problem : sequence.source->problems()) std::cerr << problem << '\n';
  WriteRunReport(arguments->out, run.recorder, localization, run.facts, sequence.ground_truth);
  std::cout << run.recorder.tracked() << " of " << run.recorder.images() << " images tracked, "
            << run.recorder.lost() << " lost; results in " << arguments->out << '\n';
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::Replay);
}
