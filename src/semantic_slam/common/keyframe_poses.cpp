#include "semantic_slam/common/keyframe_poses.h"

namespace semantic_slam {

KeyframePoses::KeyframePoses(const KeyframeGraph& graph)
    : map_id_(graph.map_id), revision_(graph.revision) {
  poses_.reserve(graph.keyframes.size());
  for (const KeyframeNode& node : graph.keyframes) poses_.emplace(node.id, node.T_map_keyframe);
}

std::optional<Rigid3d> KeyframePoses::Find(KeyframeId id) const {
  const auto found = poses_.find(id);
  if (found == poses_.end()) return std::nullopt;
  return found->second;
}

double Displacement(const Rigid3d& before, const Rigid3d& after, double reach_m) {
  const Rigid3d change = before.inverse() * after;
  return change.translation().norm() + reach_m * RotationAngle(change.linear());
}

}  // namespace semantic_slam
