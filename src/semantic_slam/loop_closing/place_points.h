#pragma once

#include <vector>

#include "semantic_slam/map/map.h"

namespace semantic_slam {

// Copies of the points that a place shows: those of a keyframe and of the ten that share most with
// it; by ascending id. The caller holds the map's mutex. Precondition: the keyframe is there.
std::vector<MapPoint> PointsAround(KeyframeId place, const Map& map);

}  // namespace semantic_slam
