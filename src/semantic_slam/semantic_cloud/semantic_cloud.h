#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {

// Thesis section 3.3.2: a point with its colour, and the three most probable labels of its pixel.
struct SemanticPoint {
  Eigen::Vector3f position;  // [m], the cloud's frame
  std::array<std::uint8_t, 3> rgb{};
  std::array<LabelId, kTopLabels> labels{};     // by descending confidence
  std::array<float, kTopLabels> confidences{};  // 0..1; their sum is at most 1
};

// A set of labels.
using LabelMask = std::bitset<256>;

// What one RGB-D image shows, in the colour camera's optical frame at `stamp`.
struct SemanticCloud {
  Stamp stamp;  // the colour image's
  std::uint64_t vocabulary_hash = 0;
  std::vector<SemanticPoint> points;  // finite; in row-major order of their pixels
};

}  // namespace semantic_slam
