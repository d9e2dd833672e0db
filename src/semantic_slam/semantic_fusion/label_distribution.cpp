#include "semantic_slam/semantic_fusion/label_distribution.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace semantic_slam {

int LabelDistribution::size() const {
  int size = 0;
  while (size < kTopLabels && labels[size] != kUnknownLabel) ++size;
  return size;
}

float LabelDistribution::others() const {
  float sum = 0.0f;
  for (const float probability : probabilities) sum += probability;
  return std::max(0.0f, 1.0f - sum);
}

float LabelDistribution::Probability(LabelId label) const {
  if (label == kUnknownLabel) return 0.0f;
  for (int i = 0; i < kTopLabels; ++i) {
    if (labels[i] == label) return probabilities[i];
  }
  return 0.0f;
}

CompactLabels::CompactLabels(const LabelDistribution& distribution) {
  std::array<int, kTopLabels> scaled{};
  for (int i = 0; i < kTopLabels; ++i)
    scaled[i] = static_cast<int>(distribution.probabilities[i] * kProbabilityOne + 0.5f);
  *this = CompactLabels(distribution.labels, scaled, distribution.observations);
}

CompactLabels::CompactLabels(const std::array<LabelId, kTopLabels>& labels,
                             const std::array<int, kTopLabels>& scaled_probabilities,
                             int observations) {
  observations = std::clamp(observations, 0, kMaxObservations);
  int left = kProbabilityOne;
  for (int i = 0; i < kTopLabels; ++i) {
    assert(scaled_probabilities[i] >= 0);
    const int probability = std::min(scaled_probabilities[i], left);
    left -= probability;
    const int word = probability | (observations >> (2 * i) & 3) << 14;
    bytes_[2 * i] = static_cast<std::uint8_t>(word);
    bytes_[2 * i + 1] = static_cast<std::uint8_t>(word >> 8);
    bytes_[2 * kTopLabels + i] = labels[i];
  }
}

CompactLabels CompactLabels::FromBytes(const std::array<std::uint8_t, kBytes>& bytes) {
  CompactLabels labels;
  labels.bytes_ = bytes;
  return labels;
}

bool CompactLabels::IsValid() const {
  int sum = 0;
  for (int i = 0; i < kTopLabels; ++i) {
    sum += scaled_probability(i);
    if (label(i) == kUnknownLabel && scaled_probability(i) != 0) return false;
    if (i > 0 && scaled_probability(i) > scaled_probability(i - 1)) return false;
  }
  return sum <= kProbabilityOne;
}

LabelDistribution CompactLabels::Unpacked() const {
  LabelDistribution distribution;
  for (int i = 0; i < kTopLabels; ++i) {
    distribution.labels[i] = label(i);
    distribution.probabilities[i] =
        static_cast<float>(scaled_probability(i)) * (1.0f / kProbabilityOne);
  }
  distribution.observations = observations();
  return distribution;
}

}  // namespace semantic_slam
