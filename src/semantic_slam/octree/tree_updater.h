#pragma once

#include <array>

#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Walks over a tree from voxel to voxel and writes occupancy. The path from the root to the current
// voxel is kept, so voxels that come in Morton order share their descent, and every inner node that
// changed is pruned or summarised once, when the walk leaves it. Equals OctoMap's updateNode() for
// every voxel followed by updateInnerOccupancy() and prune(). Not thread-safe.
class TreeUpdater {
 public:
  explicit TreeUpdater(SemanticOcTree& tree);
  ~TreeUpdater() { Leave(-1); }
  TreeUpdater(const TreeUpdater&) = delete;
  TreeUpdater& operator=(const TreeUpdater&) = delete;

  // The voxel of `key` after a ray has passed through it.
  void Miss(const octomap::OcTreeKey& key);

  // The voxel of `key` after a hit; its colour and labels are the caller's to set, at once.
  // `*was_occupied` tells what it was before.
  SemanticNode& Hit(const octomap::OcTreeKey& key, bool* was_occupied);

 private:
  static constexpr int kDepth = 16;

  struct Step {
    SemanticNode* node = nullptr;
    bool created = false;  // in this walk, so a node without children is no pruned block
    bool changed = false;
  };

  // The voxel at full depth; nullptr if it lies in a block of free space that can get no freer.
  SemanticNode* Descend(const octomap::OcTreeKey& key, bool is_hit);
  void Enter(unsigned child);

  // Goes back up until `depth` is the current one, finishing the nodes on the way.
  void Leave(int depth);

  // Returns whether the occupancy changed.
  bool AddLogOdds(SemanticNode& leaf, float log_odds) const;

  SemanticOcTree& tree_;
  std::array<Step, kDepth + 1> path_;
  int depth_ = -1;  // of the current node; -1 before the first voxel
  octomap::OcTreeKey key_;
};

}  // namespace semantic_slam
