#include "semantic_slam/octree/map_rebuild.h"

#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/clear_box.h"

namespace semantic_slam {

MapRebuild::MapRebuild(const OctreeInserter& inserter, KeyframePoses poses, Parts parts)
    : inserter_(inserter), poses_(std::move(poses)), parts_(std::move(parts)) {}

void MapRebuild::Run() {
  Run(std::atomic<bool>{false});
}

void MapRebuild::Run(const std::atomic<bool>& stop) {
  if (!tree_) tree_ = parts_.base->Copy();
  Clouds clouds;
  clouds.swap(parts_.clouds);
  for (const std::shared_ptr<const AnchoredCloud>& cloud : clouds) {
    if (stop) return;
    ClearBefore(cloud->anchor().stamp);
    Enter(cloud);
  }
  for (const ClearedBox& cleared : parts_.cleared) ClearBox(cleared.box_m, *tree_);
  parts_.cleared.clear();
}

void MapRebuild::ClearBefore(Stamp stamp) {
  auto cleared = parts_.cleared.begin();
  for (; cleared != parts_.cleared.end() && cleared->stamp < stamp; ++cleared)
    ClearBox(cleared->box_m, *tree_);
  parts_.cleared.erase(parts_.cleared.begin(), cleared);
}

void MapRebuild::Enter(const std::shared_ptr<const AnchoredCloud>& cloud) {
  const CloudAnchor& anchor = cloud->anchor();
  const auto T_map_keyframe = poses_.Find(anchor.keyframe_id);
  if (!T_map_keyframe) {
    unlisted_.insert(anchor.keyframe_id);
    return;
  }
  try {
    inserter_.Insert(cloud->Load(), *T_map_keyframe * anchor.T_keyframe_camera, *tree_);
    entered_poses_.emplace(anchor.keyframe_id, *T_map_keyframe);
  } catch (const InputError&) {
    lost_.push_back(cloud);
  }
}

}  // namespace semantic_slam
