#include "semantic_slam/octree/tree_updater.h"

namespace semantic_slam {

TreeUpdater::Step* TreeUpdater::Descend(const octomap::OcTreeKey& corner, bool any_hit) {
  if (depth_ < 0) {
    bool created = false;
    path_[0].node = tree_.EnsureRoot(&created);
    path_[0].created = path_[0].changed = created;
    depth_ = 0;
  } else {
    // The nodes above the highest bit in which the keys differ are on both paths.
    const unsigned differing = static_cast<unsigned>(
        (corner[0] ^ corner_[0]) | (corner[1] ^ corner_[1]) | (corner[2] ^ corner_[2]));
    const int shared = differing == 0 ? kBrickDepth : 16 - 32 + __builtin_clz(differing);
    if (shared < depth_) Leave(shared);
  }
  corner_ = corner;
  for (; depth_ < kBrickDepth; ++depth_) {
    Step& here = path_[depth_];
    if (!any_hit && IsFreeBlock(here)) return nullptr;
    path_[depth_ + 1] =
        Enter(here, octomap::computeChildIdx(corner, static_cast<int>(15 - depth_)));
  }
  return &path_[kBrickDepth];
}

TreeUpdater::Step TreeUpdater::Enter(Step& above, unsigned child) {
  Step below;
  if (!tree_.nodeChildExists(above.node, child)) {
    // What is expanded has to be offered to pruning again, even if no value in it changes.
    above.changed = true;
    if (!above.created && !tree_.nodeHasChildren(above.node)) {
      tree_.expandNode(above.node);
    } else {
      tree_.createNodeChild(above.node, child);
      below.created = true;
    }
  }
  below.node = tree_.getNodeChild(above.node, child);
  return below;
}

void TreeUpdater::Finish(const Step& step, Step& above) {
  if (!step.changed) return;
  if (!tree_.pruneNode(step.node)) tree_.SummariseChildren(step.node);
  above.changed = true;
}

void TreeUpdater::Leave(int depth) {
  for (; depth_ > depth; --depth_) {
    Step outside;  // of the root
    Finish(path_[depth_], depth_ > 0 ? path_[depth_ - 1] : outside);
  }
}

}  // namespace semantic_slam
