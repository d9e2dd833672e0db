#include "semantic_slam/loop_closing/map_motion.h"

namespace semantic_slam {
namespace {

// What takes a keyframe to its new pose, in the map frame: T_new * T_old^-1.
Rigid3d MotionOf(KeyframeId id, const std::map<KeyframeId, Rigid3d>& T_map_keyframes,
                 const Map& map) {
  for (const Keyframe* keyframe = map.FindKeyframe(id); keyframe != nullptr;
       keyframe = map.FindKeyframe(keyframe->parent)) {
    const auto listed = T_map_keyframes.find(keyframe->id);
    if (listed != T_map_keyframes.end()) return listed->second * keyframe->T_map_camera.inverse();
  }
  return Rigid3d::Identity();
}

std::map<KeyframeId, Rigid3d> Motions(const std::map<KeyframeId, Rigid3d>& T_map_keyframes,
                                      const Map& map) {
  std::map<KeyframeId, Rigid3d> motions;
  for (const auto& entry : map.keyframes()) {
    motions[entry.first] = MotionOf(entry.first, T_map_keyframes, map);
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
