#pragma once

#include <Eigen/Core>

#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Calls visit(centre, size_m, node) for every occupied leaf, in the tree's order; leaves that stand
// for a block of voxels are larger. `centre` is an Eigen::Vector3d in the map.
template <typename Visit>
void ForEachOccupiedLeaf(const SemanticOcTree& tree, Visit&& visit) {
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const octomap::point3d centre = leaf.getCoordinate();
    visit(Eigen::Vector3d(centre.x(), centre.y(), centre.z()), leaf.getSize(),
          static_cast<const SemanticNode&>(*leaf));
  }
}

// The smallest voxels that are occupied: calls visit(key, node), for those of a block one after the
// other.
template <typename Visit>
void ForEachOccupiedVoxel(const SemanticOcTree& tree, Visit&& visit) {
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    const octomap::OcTreeKey lowest = tree.LowestKey(leaf.getKey(), leaf.getDepth());
    const int side = 1 << (tree.getTreeDepth() - leaf.getDepth());
    for (int i = 0; i < side * side * side; ++i) {
      const octomap::OcTreeKey key(static_cast<octomap::key_type>(lowest[0] + i % side),
                                   static_cast<octomap::key_type>(lowest[1] + i / side % side),
                                   static_cast<octomap::key_type>(lowest[2] + i / side / side));
      visit(key, static_cast<const SemanticNode&>(*leaf));
    }
  }
}

}  // namespace semantic_slam
