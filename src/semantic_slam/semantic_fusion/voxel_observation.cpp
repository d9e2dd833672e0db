#include "semantic_slam/semantic_fusion/voxel_observation.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace semantic_slam {
namespace {

bool ComesFirst(const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

CompactLabels LabelsOf(const SemanticPoint& point, const LabelMask& left_out) {
  LabelDistribution distribution;
  int size = 0;
  for (int i = 0; i < kTopLabels; ++i) {
    if (point.labels[i] == kUnknownLabel || left_out[point.labels[i]]) continue;
    if (!(point.confidences[i] > 0.0f)) continue;
    distribution.labels[size] = point.labels[i];
    distribution.probabilities[size++] = point.confidences[i];
  }
  return CompactLabels(distribution);
}

}  // namespace

std::vector<VoxelObservation> ObservationsOf(const SemanticCloud& cloud,
                                             const LabelMask& transient) {
  std::vector<VoxelObservation> observations;
  observations.reserve(cloud.points.size());
  for (const SemanticPoint& point : cloud.points) {
    const bool is_transient = transient[point.labels[0]];
    observations.push_back({point.position, point.rgb,
                            LabelsOf(point, is_transient ? LabelMask() : transient), 1,
                            is_transient});
  }
  return observations;
}

void ObservationCombiner::Add(const VoxelObservation& observation, float distance) {
  if (points_ == 0 || distance < nearest_distance_ ||
      (distance == nearest_distance_ && ComesFirst(observation.position, nearest_))) {
    nearest_ = observation.position;
    nearest_distance_ = distance;
  }
  const std::uint64_t weight = observation.points;
  observation.labels.AddTo(labels_, weight);
  for (int i = 0; i < 3; ++i) rgb_[i] += weight * observation.rgb[i];
  points_ += weight;
}

VoxelObservation ObservationCombiner::Take() {
  assert(points_ > 0);
  VoxelObservation combined;
  combined.position = nearest_;
  for (int i = 0; i < 3; ++i)
    combined.rgb[i] = static_cast<std::uint8_t>((rgb_[i] + points_ / 2) / points_);
  combined.labels = CompactLabels(labels_.Take(points_ * CompactLabels::kProbabilityOne));
  combined.points = static_cast<std::uint16_t>(
      std::min<std::uint64_t>(points_, std::numeric_limits<std::uint16_t>::max()));
  rgb_.fill(0);
  points_ = 0;
  return combined;
}

}  // namespace semantic_slam
