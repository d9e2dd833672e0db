#pragma once

#include <atomic>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "semantic_slam/common/keyframe_poses.h"
#include "semantic_slam/octree/anchored_clouds.h"
#include "semantic_slam/octree/octree_inserter.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

// Somebody said that nothing is there; what is seen there later counts again.
struct ClearedBox {
  Eigen::AlignedBox3d box_m;  // in the map
  Stamp stamp;                // of the newest cloud before
};

// Makes a map again from its clouds, at the poses that a graph gives them. It has all that it
// needs, so it may run on a thread of its own while the old map goes on. For one thread at a time.
class MapRebuild {
 public:
  using Clouds = AnchoredClouds::Clouds;

  // What a map is made of, in this order: a map that was there before, then clouds, and boxes that
  // were cleared between them.
  struct Parts {
    std::shared_ptr<const SemanticOcTree> base;  // not null
    Clouds clouds;
    std::vector<ClearedBox> cleared;
  };

  MapRebuild(const OctreeInserter& inserter, KeyframePoses poses, Parts parts);

  // Enters the clouds that wait, until `stop` is set. Clouds whose keyframe is not listed are left
  // out, and so are those that have moved out of the octree or cannot be read any more.
  void Run(const std::atomic<bool>& stop);
  void Run();

  // For clouds that came meanwhile.
  void Append(std::shared_ptr<const AnchoredCloud> cloud) {
    parts_.clouds.push_back(std::move(cloud));
  }
  void Append(const ClearedBox& cleared) { parts_.cleared.push_back(cleared); }

  // What the owner of the map takes over when the work is done.
  std::unique_ptr<SemanticOcTree> TakeTree() { return std::move(tree_); }
  const std::map<KeyframeId, Rigid3d>& entered_poses() const { return entered_poses_; }
  const std::set<KeyframeId>& unlisted() const { return unlisted_; }
  const Clouds& lost() const { return lost_; }

 private:
  void Enter(const std::shared_ptr<const AnchoredCloud>& cloud);

  // Of boxes that were cleared before there was a cloud of that stamp.
  void ClearBefore(Stamp stamp);

  OctreeInserter inserter_;
  std::unique_ptr<SemanticOcTree> tree_;  // null before the first Run()
  const KeyframePoses poses_;
  Parts parts_;                                  // what waits
  std::map<KeyframeId, Rigid3d> entered_poses_;  // T_map_keyframe
  std::set<KeyframeId> unlisted_;                // keyframes of clouds that were left out
  Clouds lost_;                                  // out of the octree, or unreadable
};

}  // namespace semantic_slam
