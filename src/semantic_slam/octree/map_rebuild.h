#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <set>

#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/octree/anchored_clouds.h"
#include "semantic_slam/octree/octree_inserter.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Makes a map again from its clouds, at the poses that a graph gives them. It has all that it
// needs, so it may run on a thread of its own while the old map goes on. For one thread at a time.
class MapRebuild {
 public:
  using Clouds = AnchoredClouds::Clouds;

  // `tree` is the empty one to be filled.
  MapRebuild(const OctreeInserter& inserter, std::unique_ptr<SemanticOcTree> tree,
             KeyframePoses poses, Clouds clouds);

  // Enters the clouds that wait, until `stop` is set. Clouds whose keyframe is not listed are left
  // out, and so are those that have moved out of the octree or cannot be read any more.
  void Run(const std::atomic<bool>& stop);
  void Run();

  // For clouds that came meanwhile.
  void Append(std::shared_ptr<const AnchoredCloud> cloud) { waiting_.push_back(std::move(cloud)); }

  // What the owner of the map takes over when the work is done.
  std::unique_ptr<SemanticOcTree> TakeTree() { return std::move(tree_); }
  const std::map<KeyframeId, Rigid3d>& entered_poses() const { return entered_poses_; }
  const std::set<KeyframeId>& unlisted() const { return unlisted_; }
  const std::set<const AnchoredCloud*>& lost() const { return lost_; }

 private:
  void Enter(const AnchoredCloud& cloud);

  OctreeInserter inserter_;
  std::unique_ptr<SemanticOcTree> tree_;
  const KeyframePoses poses_;
  Clouds waiting_;
  Clouds done_;                                  // here so that the pointers in lost_ stay theirs
  std::map<KeyframeId, Rigid3d> entered_poses_;  // T_map_keyframe
  std::set<KeyframeId> unlisted_;                // keyframes of clouds that were left out
  std::set<const AnchoredCloud*> lost_;          // out of the octree, or unreadable
};

}  // namespace semantic_slam
