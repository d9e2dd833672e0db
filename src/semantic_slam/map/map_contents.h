#pragma once

#include <vector>

#include "semantic_slam/map/map.h"

namespace semantic_slam {

// A keyframe that was culled: it moves rigidly with its parent.
struct CulledKeyframe {
  KeyframeId id = kNoKeyframe;
  int map_id = 0;
  Stamp stamp;
  KeyframeId parent = kNoKeyframe;  // one that was not culled
  Rigid3d T_parent_keyframe = Rigid3d::Identity();
};

// What Map is made of, without what follows of it: points have no observations, these are told by
// the keyframes' points, and keyframes have no covisible ones.
struct MapContents {
  int map_id = 0;                      // of the present map
  KeyframeId next_keyframe = 0;        // greater than every id that was ever given away
  std::vector<Keyframe> keyframes;     // by ascending id
  std::vector<CulledKeyframe> culled;  // by ascending id
  std::vector<MapPoint> points;        // the point with id i is points[i]
  std::vector<LoopEdge> loop_edges;    // between keyframes of the above
};

}  // namespace semantic_slam
