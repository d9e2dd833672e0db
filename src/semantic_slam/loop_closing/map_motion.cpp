#include "semantic_slam/loop_closing/map_motion.h"

namespace semantic_slam {
namespace {

// What takes each keyframe to its new pose, in the map frame: T_new * T_old^-1. Parents have smaller
// ids than their children, so they are decided first.
std::map<KeyframeId, Rigid3d> Motions(const std::map<KeyframeId, Rigid3d>& T_map_keyframes,
                                      const Map& map) {
  std::map<KeyframeId, Rigid3d> motions;
  for (const auto& [id, keyframe] : map.keyframes()) {
    const auto listed = T_map_keyframes.find(id);
    const auto parent = motions.find(keyframe->parent);
    if (listed != T_map_keyframes.end()) {
      motions[id] = listed->second * keyframe->T_map_camera.inverse();
    } else if (parent != motions.end()) {
      motions[id] = parent->second;
    } else {
      motions[id] = Rigid3d::Identity();
    }
  }
  return motions;
}

}  // namespace

void MoveKeyframes(const std::map<KeyframeId, Rigid3d>& T_map_keyframes, Map& map) {
  const std::map<KeyframeId, Rigid3d> motions = Motions(T_map_keyframes, map);
  for (const auto& [id, motion] : motions) {
    Keyframe& keyframe = *map.FindKeyframe(id);
    keyframe.T_map_camera = Orthonormalised(motion * keyframe.T_map_camera);
  }
  map.ForEachPoint([&motions](MapPoint& point) {
    const Rigid3d& motion = motions.at(point.reference);
    point.position = motion * point.position;
    point.view_direction = motion.linear() * point.view_direction;
  });
}

}  // namespace semantic_slam
