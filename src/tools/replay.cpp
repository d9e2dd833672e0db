// Runs the cores on a recorded sequence, without a ROS master.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/common/heap.h"
#include "semantic_slam/localization/run_report.h"
#include "semantic_slam/localization/visual_localization.h"
#include "tools/command_line.h"
#include "tools/open_sequence.h"
#include "tools/replay_run.h"
#include "tools/replay_stages.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Runs a recorded RGB-D sequence through every stage and leaves in OUT: trajectory.txt,\n"
    "trajectory_live.txt, keyframe_trajectory.txt (TUM's format, colour optical frame in the map, z up),\n"
    "trajectory.png, timing.csv and summary.json; with the stage semantic semantic_map.ot, .bt, .ply,\n"
    "map_top.png and overview.png; with objects objects.json; with grid grid.pgm, grid.yaml and\n"
    "semantic_grid.pgm, .yaml, .png. As fast as it can, and with the same bytes on every run (but for timing.csv);\n"
    "or, with --realtime, at the sensor's rate, dropping images that come too late; summary.json has delays\n"
    "and CPU time then, and delays.csv when after its delivery each image had its pose.";

struct Arguments {
  std::string dataset;
  std::string config;
  std::string out;
  std::optional<std::string> stages;
  StageSelection selection;
  std::string save_map;  // file; empty: none
  std::string load_map;  // likewise
  bool localization_only = false;
  bool realtime = false;
};

// By default everything runs that there is a network for.
void SelectStages(const std::optional<std::string>& stages, StageSelection& selection) {
  selection.semantic = !selection.segmentation_card.empty();
  selection.objects = !selection.detection_card.empty();
  selection.grid = true;
  if (!stages) return;
  selection.semantic = selection.objects = selection.grid = false;
  bool tracking = false;
  std::map<std::string, bool*> known{{"tracking", &tracking},
                                     {"semantic", &selection.semantic},
                                     {"objects", &selection.objects},
                                     {"grid", &selection.grid}};
  std::istringstream list(*stages);
  for (std::string stage; std::getline(list, stage, ',');) {
    if (known.count(stage) == 0) {
      throw ConfigError("--stages: unknown stage '" + stage +
                        "', expected tracking, semantic, objects or grid");
    }
    *known[stage] = true;
  }
  if (!tracking) throw ConfigError("--stages: tracking is missing; every other stage needs its poses");
}

void CheckSelection(const StageSelection& selection) {
  if (selection.semantic && selection.segmentation_card.empty()) {
    throw ConfigError("--stages: the stage 'semantic' needs --segmentation CARD.yaml");
  }
  if (selection.objects && selection.detection_card.empty()) {
    throw ConfigError("--stages: the stage 'objects' needs --detection CARD.yaml");
  }
  CheckInRange("--semantic-period", selection.semantic_period_s, 0.0, 3600.0);
  CheckInRange("--object-period", selection.object_period_s, 0.0, 3600.0);
  CheckInRange("--grid-period", selection.grid_period_s, 0.0, 3600.0);
}

void CheckMapFiles(const Arguments& arguments) {
  if (!arguments.localization_only) return;
  if (arguments.load_map.empty()) {
    throw ConfigError("--localization-only needs a map to localize in: --load-map FILE");
  }
  if (!arguments.save_map.empty()) {
    throw ConfigError("--save-map with --localization-only would write the map that was loaded");
  }
}

std::optional<Arguments> ParseArguments(CommandLine& command_line) {
  Arguments arguments;
  StageSelection& selection = arguments.selection;
  command_line.RequiredOption("dataset", "DIR|FILE.bag", &arguments.dataset,
                              "a folder in TUM's format or a bag");
  command_line.RequiredOption("config", "CAMERA.yaml", &arguments.config,
                              "camera and options: config/tum_freiburg1.yaml, ...");
  command_line.RequiredOption("out", "OUT", &arguments.out, "folder for the results");
  command_line.Option("stages", "LIST", &arguments.stages,
                      "of tracking, semantic, objects, grid, separated by commas; default: all that "
                      "there is a network for");
  command_line.Option("segmentation", "CARD.yaml", &selection.segmentation_card,
                      "network of the stage semantic: config/cards/..., or truth: what "
                      "render_sequence wrote beside the images");
  command_line.Option("detection", "CARD.yaml", &selection.detection_card,
                      "network of the stage objects: config/cards/..., or truth");
  command_line.Option("models", "DIR", &selection.models, "where the networks' files lie, see docs/models.md");
  command_line.Option("labels", "LABELS.yaml", &selection.labels,
                      "the vocabulary; default: labels.yaml beside CAMERA.yaml");
  command_line.Option("semantic-period", "S", &selection.semantic_period_s,
                      "between two images of the stage semantic [s]");
  command_line.Option("object-period", "S", &selection.object_period_s, "the same of objects [s]");
  command_line.Option("grid-period", "S", &selection.grid_period_s, "the same of grid [s]");
  command_line.Option("load-map", "FILE", &arguments.load_map,
                      "begin with the map of an earlier run");
  command_line.Option("save-map", "FILE", &arguments.save_map, "keep the map in a file, at the end");
  command_line.Flag("localization-only", &arguments.localization_only,
                    "leave the loaded map as it is, and find the camera in it");
  command_line.Flag("realtime", &arguments.realtime,
                    "play at the sensor's rate and drop images that come too late");
  if (!command_line.Parse()) return std::nullopt;
  selection.dataset = arguments.dataset;
  SelectStages(arguments.stages, selection);
  CheckSelection(selection);
  CheckMapFiles(arguments);
  if (selection.labels.empty()) {
    selection.labels = std::filesystem::path(arguments.config).parent_path() / "labels.yaml";
  }
  return arguments;
}

int Replay(CommandLine& command_line) {
  const auto arguments = ParseArguments(command_line);
  if (!arguments) return EXIT_SUCCESS;
  ReplayOptions options;
  Sequence sequence = OpenSequence(arguments->dataset, arguments->config, [&options](YamlReader& file) {
    ReadReplayOptions(file, options);
  });
  const auto camera = std::make_shared<const CameraModel>(sequence.camera);
  VisualLocalization localization(options.localization, camera,
                                  arguments->realtime ? MappingMode::kThreaded : MappingMode::kInline);
  if (!arguments->load_map.empty()) localization.LoadMap(arguments->load_map);
  localization.SetMapping(!arguments->localization_only);
  ReplayStages stages(arguments->selection, options, camera,
                      arguments->realtime ? WhenFull::kDropOldest : WhenFull::kBlock);
  ReplayRun run{sequence, *camera, localization, stages, {}, {}};
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
  stages.Finish(localization.keyframe_graph(), arguments->out);
  stages.AddTo(run.facts);
  if (!arguments->save_map.empty()) localization.SaveMap(arguments->save_map);
  WriteRunReport(arguments->out, run.recorder, localization, run.facts, sequence.ground_truth);
  std::cout << run.recorder.tracked() << " of " << run.recorder.images() << " images tracked, "
            << run.recorder.lost() << " lost; results in " << arguments->out << '\n';
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  semantic_slam::ReturnLargeBlocks();
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::Replay);
}
