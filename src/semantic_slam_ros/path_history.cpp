#include "semantic_slam_ros/path_history.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace semantic_slam_ros {

using semantic_slam::KeyframeGraph;
using semantic_slam::KeyframeId;
using semantic_slam::KeyframeNode;
using semantic_slam::Rigid3d;

namespace {

const KeyframeNode* FindKeyframe(const KeyframeGraph& graph, KeyframeId id) {
  const auto& all = graph.keyframes;
  const auto found =
      std::lower_bound(all.begin(), all.end(), id,
                       [](const KeyframeNode& node, KeyframeId i) { return node.id < i; });
  return found != all.end() && found->id == id ? &*found : nullptr;
}

}  // namespace

PathHistory::PathHistory(std::size_t max_poses) : max_poses_(max_poses) {
  assert(max_poses >= 2);
}

void PathHistory::Add(const semantic_slam::TrackedImage& image, const Rigid3d& T_camera_base) {
  if (image.status != semantic_slam::TrackingStatus::kTracking) return;
  if (!entries_.empty() && ++skipped_ < stride_) return;
  skipped_ = 0;
  if (entries_.size() == max_poses_) DropEverySecond();
  entries_.push_back({image.stamp, image.keyframe_id, image.T_keyframe_camera * T_camera_base});
}

void PathHistory::DropEverySecond() {
  const std::size_t kept = (entries_.size() + 1) / 2;
  for (std::size_t i = 1; i < kept; ++i) entries_[i] = std::move(entries_[2 * i]);
  entries_.resize(kept);
  stride_ *= 2;
}

semantic_slam::Trajectory PathHistory::Poses(const KeyframeGraph& graph) const {
  semantic_slam::Trajectory poses;
  poses.reserve(entries_.size());
  for (const Entry& entry : entries_) {
    if (const KeyframeNode* keyframe = FindKeyframe(graph, entry.keyframe_id)) {
      poses.push_back({entry.stamp, keyframe->T_map_keyframe * entry.T_keyframe_base});
    }
  }
  return poses;
}

}  // namespace semantic_slam_ros
