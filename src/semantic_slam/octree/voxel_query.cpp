#include "semantic_slam/octree/voxel_query.h"

#include <array>

#include "semantic_slam/octree/occupied_voxels.h"

namespace semantic_slam {

VoxelState StateAt(const SemanticOcTree& tree, const Eigen::Vector3d& position_m) {
  VoxelState state;
  octomap::OcTreeKey key;
  if (tree.getRoot() == nullptr ||
      !tree.coordToKeyChecked(position_m.x(), position_m.y(), position_m.z(), key)) {
    return state;
  }
  const SemanticNode* node = tree.search(key);
  if (node == nullptr) return state;
  state.is_known = true;
  state.is_occupied = tree.isNodeOccupied(node);
  state.occupancy = static_cast<float>(node->getOccupancy());
  if (state.is_occupied) state.labels = node->labels().Unpacked();
  return state;
}

VoxelsFound FindVoxels(const SemanticOcTree& tree, const VoxelQuery& query) {
  VoxelsFound found;
  std::array<std::size_t, 256> voxels{};
  const auto visit = [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    const LabelId label = node.labels().label(0);
    if (query.label && label != *query.label) return;
    ++voxels[label];
    ++found.voxels;
    const Eigen::Vector3d centre = CentreOf(tree, key);
    const double distance = (centre - query.near_m).norm();
    if (!found.nearest || distance < found.nearest->distance_m)
      found.nearest = VoxelsFound::Nearest{label, centre, distance};
  };
  if (query.box_m) {
    ForEachOccupiedVoxel(tree, *query.box_m, visit);
  } else {
    ForEachOccupiedVoxel(tree, visit);
  }
  for (std::size_t label = 0; label < voxels.size(); ++label) {
    if (voxels[label] > 0) found.labels.push_back({static_cast<LabelId>(label), voxels[label]});
  }
  return found;
}

}  // namespace semantic_slam
