// Compares what a run has left with the simulated world that it was in.

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/class_list.h"
#include "semantic_slam/evaluation/trajectory_plot.h"
#include "semantic_slam/ground_truth/map_comparison_picture.h"
#include "semantic_slam/ground_truth/map_evaluation.h"
#include "semantic_slam/ground_truth/map_report.h"
#include "semantic_slam/worlds/world_file.h"
#include "tools/command_line.h"
#include "tools/config_folder.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Compares the maps that replay or the nodes have left in OUT with the world that they are of:\n"
    "the labels of semantic_map.ot's voxels with the surfaces there, objects.json with the "
    "objects\n"
    "that were in view, grid.yaml and semantic_grid.yaml with the true floor plan at the flight\n"
    "height; all after alignment of trajectory.txt to the true trajectory. What OUT does not hold "
    "is\n"
    "shown as \"-\".";

struct Arguments {
  std::string world;
  std::string out;
  std::string truth;
  std::string labels;
  std::string camera;
  std::optional<std::string> voxel_classes;
  std::optional<std::string> object_classes;
  std::optional<std::string> plot;
  bool json = false;
};

MapEvaluationOptions OptionsOf(const Arguments& arguments, const LabelVocabulary& vocabulary) {
  MapEvaluationOptions options;
  if (arguments.voxel_classes) {
    options.voxel_classes = ReadClassList(*arguments.voxel_classes, vocabulary);
  }
  if (arguments.object_classes) {
    options.object_classes = ReadClassList(*arguments.object_classes, vocabulary);
  }
  return options;
}

// nullopt after printing the help.
std::optional<Arguments> ParseArguments(CommandLine& command_line) {
  Arguments arguments;
  command_line.Argument("WORLD", &arguments.world,
                        "world file, or the name of one in config/worlds");
  command_line.Argument("OUT", &arguments.out, "folder with the results");
  command_line.Option("truth", "FILE", &arguments.truth,
                      "true trajectory of the optical frame in TUM's format; default: "
                      "OUT/groundtruth.txt");
  command_line.Option("camera", "CAMERA.yaml", &arguments.camera,
                      "tells which objects were in view; default: config/simulated_d455.yaml");
  command_line.Option("labels", "LABELS.yaml", &arguments.labels,
                      "the vocabulary; default: config/labels.yaml");
  command_line.Option(
      "voxel-classes", "CLASSES.yaml", &arguments.voxel_classes,
      "what the voxels' labels count as, like training/classes/indoor.yaml; default: "
      "each as itself");
  command_line.Option("object-classes", "CLASSES.yaml", &arguments.object_classes,
                      "of objects that the map should hold, like training/classes/furniture.yaml; "
                      "default: all but people and animals");
  command_line.Option("plot", "FILE.png", &arguments.plot, "draw the truth beside the maps");
  command_line.Flag("json", &arguments.json, "print JSON instead of a table");
  if (!command_line.Parse()) return std::nullopt;
  return arguments;
}

int Evaluate(CommandLine& command_line) {
  const std::optional<Arguments> arguments = ParseArguments(command_line);
  if (!arguments) return EXIT_SUCCESS;
  if (arguments->plot) CheckPlotPath(*arguments->plot);
  const LabelVocabulary vocabulary =
      LabelVocabulary::Load(ConfigFile(arguments->labels, "labels.yaml"));
  const CameraModel camera(
      LoadCameraConfig(ConfigFile(arguments->camera, "simulated_d455.yaml")).intrinsics);
  const World world = LoadWorld(FindInConfig(arguments->world, "worlds"), vocabulary);
  const RunOutputs outputs = ReadRunOutputs(arguments->out, vocabulary);
  const std::filesystem::path own_truth = std::filesystem::path(arguments->out) / "groundtruth.txt";
  const Trajectory truth =
      ReadTumTrajectory(arguments->truth.empty() ? own_truth.string() : arguments->truth);
  const MapEvaluation evaluation =
      EvaluateMaps(world, vocabulary, truth, camera, outputs, OptionsOf(*arguments, vocabulary));
  if (arguments->plot)
    WritePlot(DrawMapComparison(evaluation, outputs, vocabulary), *arguments->plot);
  if (arguments->json) {
    std::cout << ToJson(evaluation, vocabulary).dump(2) << '\n';
  } else {
    PrintTable(evaluation, vocabulary, std::cout);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::Evaluate);
}
