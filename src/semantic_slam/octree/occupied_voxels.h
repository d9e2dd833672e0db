#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

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

inline Eigen::Vector3d CentreOf(const SemanticOcTree& tree, const octomap::OcTreeKey& key) {
  return {tree.keyToCoord(key[0]), tree.keyToCoord(key[1]), tree.keyToCoord(key[2])};
}

// Calls visit(key) for the smallest voxels that a leaf (an iterator of OctoMap's) stands for.
template <typename Leaf, typename Visit>
void ForEachVoxelOf(const SemanticOcTree& tree, const Leaf& leaf, Visit&& visit) {
  const octomap::OcTreeKey lowest = tree.LowestKey(leaf.getKey(), leaf.getDepth());
  const int side = 1 << (tree.getTreeDepth() - leaf.getDepth());
  for (int i = 0; i < side * side * side; ++i) {
    visit(octomap::OcTreeKey(static_cast<octomap::key_type>(lowest[0] + i % side),
                             static_cast<octomap::key_type>(lowest[1] + i / side % side),
                             static_cast<octomap::key_type>(lowest[2] + i / side / side)));
  }
}

// The smallest voxels that are occupied: calls visit(key, node), for those of a block one after the
// other.
template <typename Visit>
void ForEachOccupiedVoxel(const SemanticOcTree& tree, Visit&& visit) {
  for (auto leaf = tree.begin_leafs(), end = tree.end_leafs(); leaf != end; ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    ForEachVoxelOf(tree, leaf, [&](const octomap::OcTreeKey& key) {
      visit(key, static_cast<const SemanticNode&>(*leaf));
    });
  }
}

// The same, of those whose centre lies in `box_m`.
template <typename Visit>
void ForEachOccupiedVoxel(const SemanticOcTree& tree, const Eigen::AlignedBox3d& box_m,
                          Visit&& visit) {
  if (box_m.isEmpty() || tree.getRoot() == nullptr) return;
  const auto corner = [&](const Eigen::Vector3d& p) {
    return octomap::OcTreeKey(tree.ClampedKey(p.x()), tree.ClampedKey(p.y()),
                              tree.ClampedKey(p.z()));
  };
  const octomap::OcTreeKey low = corner(box_m.min()), high = corner(box_m.max());
  for (auto leaf = tree.begin_leafs_bbx(low, high), end = tree.end_leafs_bbx(); leaf != end;
       ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    ForEachVoxelOf(tree, leaf, [&](const octomap::OcTreeKey& key) {
      if (box_m.contains(CentreOf(tree, key))) visit(key, static_cast<const SemanticNode&>(*leaf));
    });
  }
}

}  // namespace semantic_slam
