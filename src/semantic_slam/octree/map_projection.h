#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/octree/semantic_octree.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

namespace semantic_slam {

struct MapProjectionOptions {
  double min_z_m = -std::numeric_limits<double>::max();  // of voxels' centres, in the map
  double max_z_m = std::numeric_limits<double>::max();
  LabelMask left_out;  // voxels of these labels stand in nobody's way
};

// A map from above: is there anything in a column?
struct ProjectedMap {
  enum Cell : std::int8_t { kUnknown = -1, kFree = 0, kOccupied = 100 };

  double resolution_m = 0.0;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  // the lowest corner of the first cell
  int width = 0;                                       // cells along x
  int height = 0;                                      // along y
  std::vector<std::int8_t> cells;                      // row by row, y upwards
};

// Occupied is a column with an occupied voxel that counts; free one with a known voxel, be it one
// that is left out. It reaches as far as anything is known; an empty map gives one without cells.
ProjectedMap ProjectDown(const SemanticOcTree& tree, const MapProjectionOptions& options);

}  // namespace semantic_slam
