#include "semantic_slam/octree/map_rebuild.h"

#include <utility>

#include "semantic_slam/common/error.h"

namespace semantic_slam {

MapRebuild::MapRebuild(const OctreeInserter& inserter, std::unique_ptr<SemanticOcTree> tree,
                       KeyframePoses poses, Clouds clouds)
    : inserter_(inserter),
      tree_(std::move(tree)),
      poses_(std::move(poses)),
      waiting_(std::move(clouds)) {}

void MapRebuild::Run() {
  Run(std::atomic<bool>{false});
}

void MapRebuild::Run(const std::atomic<bool>& stop) {
  Clouds clouds;
  clouds.swap(waiting_);
  for (std::shared_ptr<const AnchoredCloud>& cloud : clouds) {
    if (stop) return;
    Enter(*cloud);
    done_.push_back(std::move(cloud));
  }
}

void MapRebuild::Enter(const AnchoredCloud& cloud) {
  const CloudAnchor& anchor = cloud.anchor();
  const auto T_map_keyframe = poses_.Find(anchor.keyframe_id);
  if (!T_map_keyframe) {
    unlisted_.insert(anchor.keyframe_id);
    return;
  }
  try {
    inserter_.Insert(cloud.Load(), *T_map_keyframe * anchor.T_keyframe_camera, *tree_);
    entered_poses_.emplace(anchor.keyframe_id, *T_map_keyframe);
  } catch (const InputError&) {
    lost_.insert(&cloud);
  }
}

}  // namespace semantic_slam
