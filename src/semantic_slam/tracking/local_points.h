#pragma once

#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/tracking/frame_in_work.h"

namespace semantic_slam {

// The points of at most `max_keyframes` keyframes that share points with the frame, and of those
// keyframes' neighbours; by ascending id. Also makes the keyframe that shares most the frame's
// reference. The caller holds the map's mutex.
std::vector<PointId> CollectLocalPoints(const Map& map, int max_keyframes, FrameInWork& frame);

struct LocalMatching {
  float widen = 1.0f;         // of the search, where the pose is still rough
  bool count_visible = true;  // points that should be seen remember it
};

// Looks for those points in the frame, where its pose expects them.
void MatchLocalPoints(const std::vector<PointId>& local_points, const CameraModel& camera,
                      const LocalMatching& matching, Map& map, FrameInWork& frame);

}  // namespace semantic_slam
