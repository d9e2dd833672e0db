#include "semantic_slam/octree/tree_updater.h"

#include <algorithm>

namespace semantic_slam {

TreeUpdater::TreeUpdater(SemanticOcTree& tree) : tree_(tree) {}

void TreeUpdater::Miss(const octomap::OcTreeKey& key) {
  SemanticNode* leaf = Descend(key, false);
  if (leaf != nullptr && AddLogOdds(*leaf, tree_.miss_log_odds())) path_[kDepth].changed = true;
}

SemanticNode& TreeUpdater::Hit(const octomap::OcTreeKey& key, bool* was_occupied) {
  SemanticNode* leaf = Descend(key, true);
  *was_occupied = !path_[kDepth].created && tree_.isNodeOccupied(leaf);
  AddLogOdds(*leaf, tree_.hit_log_odds());
  path_[kDepth].changed = true;  // its labels will
  return *leaf;
}

SemanticNode* TreeUpdater::Descend(const octomap::OcTreeKey& key, bool is_hit) {
  if (depth_ < 0) {
    bool created = false;
    path_[0].node = tree_.EnsureRoot(&created);
    path_[0].created = path_[0].changed = created;
    depth_ = 0;
  } else {
    // The nodes above the highest bit in which the keys differ are on both paths.
    const unsigned differing =
        static_cast<unsigned>((key[0] ^ key_[0]) | (key[1] ^ key_[1]) | (key[2] ^ key_[2]));
    const int shared = differing == 0 ? kDepth : kDepth - 32 + __builtin_clz(differing);
    if (shared < depth_) Leave(shared);
  }
  key_ = key;
  while (depth_ < kDepth) {
    const Step& here = path_[depth_];
    const unsigned child = octomap::computeChildIdx(key, kDepth - 1 - depth_);
    if (!tree_.nodeChildExists(here.node, child) && !here.created && !is_hit &&
        here.node->getLogOdds() <= tree_.getClampingThresMinLog() &&
        !tree_.nodeHasChildren(here.node)) {
      return nullptr;
    }
    Enter(child);
  }
  return path_[kDepth].node;
}

void TreeUpdater::Enter(unsigned child) {
  Step& here = path_[depth_];
  Step& below = path_[depth_ + 1];
  below.created = below.changed = false;
  if (!tree_.nodeChildExists(here.node, child)) {
    // What is expanded has to be offered to pruning again, even if no value in it changes.
    here.changed = true;
    if (!here.created && !tree_.nodeHasChildren(here.node)) {
      tree_.expandNode(here.node);
    } else {
      tree_.createNodeChild(here.node, child);
      below.created = true;
    }
  }
  below.node = tree_.getNodeChild(here.node, child);
  ++depth_;
}

void TreeUpdater::Leave(int depth) {
  for (; depth_ > depth; --depth_) {
    const Step& here = path_[depth_];
    if (!here.changed) continue;
    if (depth_ < kDepth && !tree_.pruneNode(here.node)) tree_.SummariseChildren(here.node);
    if (depth_ > 0) path_[depth_ - 1].changed = true;
  }
}

bool TreeUpdater::AddLogOdds(SemanticNode& leaf, float log_odds) const {
  const float before = leaf.getLogOdds();
  const float after = std::min(std::max(before + log_odds, tree_.getClampingThresMinLog()),
                               tree_.getClampingThresMaxLog());
  leaf.setLogOdds(after);
  return after != before;
}

}  // namespace semantic_slam
