#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// What is known of the floor plan at the flight height, in the map frame; as nav_msgs/OccupancyGrid.
struct OccupancyMap {
  static constexpr std::int8_t kUnknown = -1;

  Stamp stamp;  // the newest scan in it
  int map_id = 0;
  std::uint64_t revision = 0;  // of the keyframe graph that it follows
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  // lower left corner of cell (0, 0)
  int width = 0;   // cells along x
  int height = 0;  // cells along y
  std::vector<std::int8_t> cells;  // row-major, y * width + x: kUnknown, or occupied in percent, 0..100
};

}  // namespace semantic_slam
