#include "semantic_slam/octree/packed_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace semantic_slam {
namespace {

constexpr float kMostUnits = std::numeric_limits<std::int16_t>::max();
constexpr int kMostPoints = std::numeric_limits<std::uint8_t>::max();
constexpr int kByteOne = 255;  // a probability of one

int Rescaled(int value, int from, int to) {
  return (value * to + from / 2) / from;
}

}  // namespace

PackedCloud Pack(const std::vector<VoxelObservation>& observations) {
  PackedCloud cloud;
  float farthest = 0.0f;
  for (const VoxelObservation& observation : observations)
    farthest = std::max(farthest, observation.position.cwiseAbs().maxCoeff());
  if (farthest > 0.0f) cloud.unit_m = farthest / kMostUnits;
  const float units_per_m = 1.0f / cloud.unit_m;
  cloud.observations.reserve(observations.size());
  for (const VoxelObservation& observation : observations) {
    PackedObservation packed{};
    for (int i = 0; i < 3; ++i) {
      const float units =
          std::clamp(observation.position[i] * units_per_m, -kMostUnits, kMostUnits);
      packed.position[i] = static_cast<std::int16_t>(std::lround(units));
    }
    if (!observation.is_only_seen) {
      packed.rgb = observation.rgb;
      for (int i = 0; i < kTopLabels; ++i) {
        packed.labels[i] = observation.labels.label(i);
        packed.probabilities[i] = static_cast<std::uint8_t>(Rescaled(
            observation.labels.scaled_probability(i), CompactLabels::kProbabilityOne, kByteOne));
      }
      packed.points =
          static_cast<std::uint8_t>(std::clamp<int>(observation.points, 1, kMostPoints));
    }
    cloud.observations.push_back(packed);
  }
  return cloud;
}

std::vector<VoxelObservation> Unpack(const PackedCloud& cloud) {
  std::vector<VoxelObservation> observations;
  observations.reserve(cloud.observations.size());
  for (const PackedObservation& packed : cloud.observations) {
    VoxelObservation observation;
    for (int i = 0; i < 3; ++i)
      observation.position[i] = static_cast<float>(packed.position[i]) * cloud.unit_m;
    observation.is_only_seen = packed.points == 0;
    if (!observation.is_only_seen) {
      observation.rgb = packed.rgb;
      std::array<int, kTopLabels> scaled{};
      for (int i = 0; i < kTopLabels; ++i)
        scaled[i] = Rescaled(packed.probabilities[i], kByteOne, CompactLabels::kProbabilityOne);
      observation.labels = CompactLabels(packed.labels, scaled, 0);
      observation.points = packed.points;
    }
    observations.push_back(observation);
  }
  return observations;
}

}  // namespace semantic_slam
