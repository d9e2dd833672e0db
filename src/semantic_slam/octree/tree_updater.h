#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "semantic_slam/octree/scan_grid.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Walks over a tree from brick to brick of 8 x 8 x 8 voxels and writes occupancy. The path from the
// root to the current brick is kept, so bricks that come in Morton order share their descent, and
// every inner node that changed is pruned or summarised once, when the walk leaves it. Equals
// OctoMap's updateNode() for every voxel followed by updateInnerOccupancy() and prune(). Not
// thread-safe.
class TreeUpdater {
 public:
  explicit TreeUpdater(SemanticOcTree& tree) : tree_(tree) {}
  ~TreeUpdater() { Leave(-1); }
  TreeUpdater(const TreeUpdater&) = delete;
  TreeUpdater& operator=(const TreeUpdater&) = delete;

  // The voxels of `brick` after rays have passed through the free ones and something was hit in the
  // others. For each hit calls on_hit(node, was_occupied, place): colour and labels are the
  // caller's to set, `was_occupied` tells what it was before, `place` is the voxel's in the brick.
  // Preconditions: no voxel is both, and there is at least one.
  template <typename OnHit>
  void Update(const ScanGrid::Brick& brick, OnHit&& on_hit);

 private:
  static constexpr int kBrickDepth = 13;

  struct Step {
    SemanticNode* node = nullptr;
    bool created = false;  // in this walk, so a node without children is no pruned block
    bool changed = false;
  };

  // The node of the brick with that corner; nullptr if it lies in a block of free space that can
  // get no freer, and nothing is hit there.
  Step* Descend(const octomap::OcTreeKey& corner, bool any_hit);

  // Goes back up until `depth` is the current one, finishing the nodes on the way.
  void Leave(int depth);

  // The step to the child of that number, which is made if it is not there.
  Step Enter(Step& above, unsigned child);
  void Finish(const Step& step, Step& above);

  // Whether `step` stands for a block of free space that can get no freer.
  bool IsFreeBlock(const Step& step) const {
    return !step.created && tree_.CanGetNoFreer(step.node);
  }

  // The 8^kLevels voxels below `step`; `free` and `hit` are theirs, `first` is the first one's
  // place in the brick.
  template <int kLevels, typename OnHit>
  void UpdateBlock(Step& step, std::uint64_t free, std::uint64_t hit, unsigned first,
                   OnHit& on_hit);
  template <typename OnHit>
  void UpdateVoxel(Step& step, bool is_hit, unsigned place, OnHit& on_hit);

  SemanticOcTree& tree_;
  std::array<Step, kBrickDepth + 1> path_;
  int depth_ = -1;  // of the current node; -1 before the first brick
  octomap::OcTreeKey corner_;
};

template <typename OnHit>
void TreeUpdater::Update(const ScanGrid::Brick& brick, OnHit&& on_hit) {
  std::uint64_t any_hit = 0;
  for (const std::uint64_t word : brick.hit) any_hit |= word;
  Step* step = Descend(brick.corner, any_hit != 0);
  if (step == nullptr) return;
  for (unsigned word = 0; word < 8; ++word) {
    const std::uint64_t free = brick.free[word], hit = brick.hit[word];
    if ((free | hit) == 0 || (hit == 0 && IsFreeBlock(*step))) continue;
    Step below = Enter(*step, word);
    UpdateBlock<2>(below, free, hit, word << 6, on_hit);
    Finish(below, *step);
  }
}

template <int kLevels, typename OnHit>
void TreeUpdater::UpdateBlock(Step& step, std::uint64_t free, std::uint64_t hit, unsigned first,
                              OnHit& on_hit) {
  if constexpr (kLevels == 0) {
    UpdateVoxel(step, hit != 0, first, on_hit);
  } else {
    constexpr unsigned kBits = kLevels == 2 ? 8 : 1;  // voxels below a child
    constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;
    for (unsigned child = 0; child < 8; ++child, free >>= kBits, hit >>= kBits) {
      const std::uint64_t child_free = free & kMask, child_hit = hit & kMask;
      if ((child_free | child_hit) == 0) continue;
      if (child_hit == 0 && IsFreeBlock(step)) continue;
      Step below = Enter(step, child);
      UpdateBlock<kLevels - 1>(below, child_free, child_hit, first + kBits * child, on_hit);
      if constexpr (kLevels == 1) {
        step.changed |= below.changed;
      } else {
        Finish(below, step);
      }
    }
  }
}

template <typename OnHit>
void TreeUpdater::UpdateVoxel(Step& step, bool is_hit, unsigned place, OnHit& on_hit) {
  SemanticNode& leaf = *step.node;
  const float before = leaf.getLogOdds();
  const float after = std::clamp(before + (is_hit ? tree_.hit_log_odds() : tree_.miss_log_odds()),
                                 tree_.getClampingThresMinLog(), tree_.getClampingThresMaxLog());
  const bool was_occupied = !step.created && tree_.isNodeOccupied(leaf);
  leaf.setLogOdds(after);
  step.changed |= is_hit || after != before;  // a hit's labels change
  if (is_hit) on_hit(leaf, was_occupied, place);
}

}  // namespace semantic_slam
