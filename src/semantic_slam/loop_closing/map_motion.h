#pragma once

#include <map>

#include "semantic_slam/map/map.h"

namespace semantic_slam {

// Puts keyframes at new poses. Keyframes that are not listed move rigidly with their parents, and
// every point with the keyframe that gives its scale. The caller holds the map's mutex.
void MoveKeyframes(const std::map<KeyframeId, Rigid3d>& T_map_keyframes, Map& map);

}  // namespace semantic_slam
