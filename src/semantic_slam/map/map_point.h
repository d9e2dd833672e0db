#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/features/frame_features.h"

namespace semantic_slam {

using PointId = std::int64_t;
constexpr PointId kNoPoint = -1;

// Where a map point was seen.
struct Observation {
  KeyframeId keyframe;
  int feature;  // index into the keyframe's features
};

// One landmark. Positions and directions are in the map frame.
struct MapPoint {
  PointId id = kNoPoint;
  int map_id = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();        // [m]
  Eigen::Vector3d view_direction = Eigen::Vector3d::Zero();  // unit; mean, from point to cameras
  // Distances at which its patch fits the pyramid's levels [m].
  double min_distance_m = 0.0;
  double max_distance_m = 0.0;
  Descriptor descriptor{};
  std::array<std::uint8_t, 3> rgb{};
  KeyframeId reference = kNoKeyframe;     // the keyframe that gives its scale
  std::vector<Observation> observations;  // by ascending keyframe
  // Since its birth: images in which it should have been seen, and in which it was matched.
  int visible = 1;
  int found = 1;
};

}  // namespace semantic_slam
