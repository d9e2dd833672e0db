#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// The probabilistic semantic grid of thesis section 3.4.4, in the map frame. Cells are row-major,
// y * width + x.
struct SemanticCells {
  static constexpr std::uint8_t kFree = 0;  // as in costmap_2d
  static constexpr std::uint8_t kInscribed = 253;
  static constexpr std::uint8_t kLethal = 254;
  static constexpr std::uint8_t kUnknown = 255;

  Stamp stamp;  // the newest image in it
  int map_id = 0;
  std::uint64_t revision = 0;  // of the keyframe graph that the cells follow
  std::uint64_t vocabulary_hash = 0;
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();  // lower left corner of cell (0, 0)
  int width = 0;                                       // cells along x
  int height = 0;                                      // cells along y

  std::vector<std::uint8_t> cost;  // one of the constants or between

  int classes_per_cell = 3;                  // k
  std::vector<LabelId> labels;               // k per cell by descending probability; 0 unknown
  // As labels; floor(255 p). Things stand on each other, so those of a cell may sum up to more than 1.
  std::vector<std::uint8_t> probabilities;

  std::vector<float> min_height_m;  // lowest thing in the cell; NaN where nothing was seen
  std::vector<float> max_height_m;  // highest thing in the cell; NaN where nothing was seen
};

}  // namespace semantic_slam
