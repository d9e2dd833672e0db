#include "semantic_slam/localization/trajectory_recorder.h"

#include <map>

namespace semantic_slam {

void TrajectoryRecorder::Add(const TrackedImage& image) {
  ++images_;
  if (image.status == TrackingStatus::kLost) ++lost_;
  if (image.status != TrackingStatus::kTracking) return;
  live_.push_back({image.stamp, image.T_map_camera});
  entries_.push_back({image.keyframe_id, image.T_keyframe_camera});
}

Trajectory TrajectoryRecorder::Corrected(const KeyframeGraph& graph) const {
  std::map<KeyframeId, Rigid3d> T_map_keyframe;
  for (const KeyframeNode& node : graph.keyframes) T_map_keyframe[node.id] = node.T_map_keyframe;
  Trajectory corrected;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto keyframe = T_map_keyframe.find(entries_[i].keyframe_id);
    if (keyframe == T_map_keyframe.end()) continue;
    corrected.push_back({live_[i].stamp, keyframe->second * entries_[i].T_keyframe_camera});
  }
  return corrected;
}

Trajectory KeyframeTrajectory(const KeyframeGraph& graph) {
  Trajectory trajectory;
  for (const KeyframeNode& node : graph.keyframes) {
    if (!node.culled) trajectory.push_back({node.stamp, node.T_map_keyframe});
  }
  return trajectory;
}

}  // namespace semantic_slam
