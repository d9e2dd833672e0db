#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/semantic_cloud/semantic_cloud.h"
#include "semantic_slam/semantic_fusion/label_distribution.h"

namespace semantic_slam {

// What some points of one image, all in one voxel, say together: the one observation that the voxel
// gets from the image. A single point is one too.
struct VoxelObservation {
  Eigen::Vector3f position;           // of one of the points [m], in the camera's optical frame
  std::array<std::uint8_t, 3> rgb{};  // mean
  CompactLabels labels;               // mean of the points' confidences
  std::uint16_t points = 1;           // how many; stops at 65535
  // Of a thing that will not stay, a person: the camera sees up to it, but the map does not get it.
  bool is_transient = false;
};

// A set of labels.
using LabelMask = std::bitset<256>;

// One observation per point. Transient are those whose most probable label is in `transient`; the
// others say nothing of such labels, so that no map ever shows one. Precondition: the cloud passes
// CheckSemanticCloud().
std::vector<VoxelObservation> ObservationsOf(const SemanticCloud& cloud,
                                             const LabelMask& transient);

// Combines observations of one voxel. The result is the same in whatever order they come: every sum
// is of whole numbers. Each point counts as much as every other, so a label counts by the
// confidence that the points have in it. Reusable; not thread-safe.
class ObservationCombiner {
 public:
  // `distance` is the position's from the voxel's centre: the nearest one is kept, as it is the
  // least likely to leave the voxel when the camera's pose is corrected; of equally near ones the
  // one of smaller coordinates.
  void Add(const VoxelObservation& observation, float distance);

  bool empty() const { return points_ == 0; }

  // All added since the last call, not transient; then forgets them. Precondition: !empty().
  VoxelObservation Take();

 private:
  LabelSum labels_;
  std::array<std::uint64_t, 3> rgb_{};
  std::uint64_t points_ = 0;
  float nearest_distance_ = 0.0f;
  Eigen::Vector3f nearest_ = Eigen::Vector3f::Zero();
};

}  // namespace semantic_slam
