#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "semantic_slam/semantic_fusion/label_distribution.h"

namespace semantic_slam {

// What the points of one image in one voxel say together: the one observation that the voxel gets
// from the image.
struct VoxelObservation {
  Eigen::Vector3f position;           // the points' mean [m], in the camera's optical frame
  std::array<std::uint8_t, 3> rgb{};  // mean
  CompactLabels labels;               // mean of the points' confidences
  std::uint16_t points = 1;           // how many; stops at 65535
  // Nothing is to be entered there, but the camera saw up to it: a person, who will not stay, or
  // what is too far away to be trusted. Has neither colour nor labels.
  bool is_only_seen = false;
};

}  // namespace semantic_slam
