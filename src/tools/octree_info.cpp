// Tells what a semantic map holds.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "semantic_slam/octree/occupied_voxels.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "tools/command_line.h"

namespace semantic_slam {
namespace {

constexpr char kPurpose[] =
    "Tells what a semantic map (semantic_map.ot, as octomap_node and replay leave it) holds: its "
    "size,\n"
    "where it lies, and how many occupied voxels each class has.";

struct Statistics {
  double resolution_m = 0.0;
  std::size_t nodes = 0;
  std::size_t leaves = 0;
  std::size_t occupied_voxels = 0;
  Eigen::Vector3d low_m = Eigen::Vector3d::Zero();  // of the occupied voxels
  Eigen::Vector3d high_m = Eigen::Vector3d::Zero();
  std::vector<std::pair<LabelId, std::size_t>> voxels_per_label;  // most first
};

Statistics Gather(const SemanticOcTree& tree) {
  Statistics statistics;
  statistics.resolution_m = tree.getResolution();
  statistics.nodes = tree.size();
  statistics.leaves = tree.getRoot() == nullptr ? 0 : tree.getNumLeafNodes();
  std::map<LabelId, std::size_t> voxels;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * tree.getResolution());
  ForEachOccupiedVoxel(tree, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    const Eigen::Vector3d centre(tree.keyToCoord(key[0]), tree.keyToCoord(key[1]),
                                 tree.keyToCoord(key[2]));
    const bool is_first = statistics.occupied_voxels++ == 0;
    statistics.low_m = is_first ? centre - half : statistics.low_m.cwiseMin(centre - half).eval();
    statistics.high_m = is_first ? centre + half : statistics.high_m.cwiseMax(centre + half).eval();
    ++voxels[node.labels().label(0)];
  });
  statistics.voxels_per_label.assign(voxels.begin(), voxels.end());
  std::stable_sort(statistics.voxels_per_label.begin(), statistics.voxels_per_label.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return statistics;
}

double VolumeM3(std::size_t voxels, const Statistics& statistics) {
  return static_cast<double>(voxels) * statistics.resolution_m * statistics.resolution_m *
         statistics.resolution_m;
}

nlohmann::ordered_json ToJson(const Statistics& statistics, const LabelVocabulary& vocabulary) {
  nlohmann::ordered_json json;
  json["resolution_m"] = statistics.resolution_m;
  json["nodes"] = statistics.nodes;
  json["leaves"] = statistics.leaves;
  json["occupied_voxels"] = statistics.occupied_voxels;
  json["min_m"] = {statistics.low_m.x(), statistics.low_m.y(), statistics.low_m.z()};
  json["max_m"] = {statistics.high_m.x(), statistics.high_m.y(), statistics.high_m.z()};
  json["label_set_hash"] = vocabulary.hash();
  json["classes"] = nlohmann::ordered_json::array();
  for (const auto& [label, voxels] : statistics.voxels_per_label) {
    json["classes"].push_back({{"id", label},
                               {"name", vocabulary[label].name},
                               {"voxels", voxels},
                               {"volume_m3", VolumeM3(voxels, statistics)}});
  }
  return json;
}

void Print(const Statistics& statistics, const LabelVocabulary& vocabulary) {
  std::printf("resolution        %g m\n", statistics.resolution_m);
  std::printf("nodes, leaves     %zu, %zu\n", statistics.nodes, statistics.leaves);
  std::printf("occupied voxels   %zu\n", statistics.occupied_voxels);
  const Eigen::Vector3d &low = statistics.low_m, &high = statistics.high_m;
  std::printf("x, y, z [m]       %.2f to %.2f, %.2f to %.2f, %.2f to %.2f\n", low.x(), high.x(),
              low.y(), high.y(), low.z(), high.z());
  std::printf("\n%-18s %10s %12s\n", "class", "voxels", "volume [m3]");
  for (const auto& [label, voxels] : statistics.voxels_per_label) {
    std::printf("%-18s %10zu %12.3f\n", vocabulary[label].name.c_str(), voxels,
                VolumeM3(voxels, statistics));
  }
}

int OctreeInfo(CommandLine& command_line) {
  std::string path;
  bool json = false;
  command_line.Argument("MAP.ot", &path, "a semantic map");
  command_line.Flag("json", &json, "print JSON instead of a table");
  if (!command_line.Parse()) return EXIT_SUCCESS;
  const LabelledTree map = ReadLabelledTree(path);
  const Statistics statistics = Gather(*map.tree);
  if (json) {
    std::cout << ToJson(statistics, map.vocabulary).dump(2) << '\n';
  } else {
    Print(statistics, map.vocabulary);
  }
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace semantic_slam

int main(int argc, char** argv) {
  return semantic_slam::RunProgram(argc, argv, semantic_slam::kPurpose, semantic_slam::OctreeInfo);
}
