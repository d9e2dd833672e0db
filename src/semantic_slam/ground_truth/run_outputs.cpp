#include "semantic_slam/ground_truth/run_outputs.h"

#include <filesystem>

#include "semantic_slam/common/error.h"
#include "semantic_slam/object_mapping/object_map_file.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "semantic_slam/submaps/occupancy_map_file.h"

namespace semantic_slam {

namespace fs = std::filesystem;

RunOutputs ReadRunOutputs(const std::string& folder, const LabelVocabulary& vocabulary) {
  if (!fs::is_directory(folder)) throw InputError("no such folder: " + folder);
  const auto path = [&](const char* name) { return (fs::path(folder) / name).string(); };
  const auto is_there = [&](const char* name) { return fs::exists(path(name)); };
  RunOutputs outputs;
  outputs.trajectory = ReadTumTrajectory(path("trajectory.txt"));
  if (is_there("semantic_map.ot")) {
    outputs.tree = ReadSemanticTree(path("semantic_map.ot"), vocabulary);
  }
  if (is_there("objects.json")) outputs.objects = ReadObjectMap(path("objects.json"), vocabulary);
  if (is_there("grid.yaml")) outputs.grid = ReadOccupancyMap(path("grid.yaml"));
  if (is_there("semantic_grid.yaml")) {
    outputs.semantic_grid = ReadOccupancyMap(path("semantic_grid.yaml"));
  }
  return outputs;
}

}  // namespace semantic_slam
