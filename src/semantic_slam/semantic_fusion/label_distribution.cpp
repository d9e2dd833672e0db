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

LabelDistribution LabelSum::Take(std::uint64_t total) {
  const auto heavier = [this](LabelId a, LabelId b) {
    return weights_[a] != weights_[b] ? weights_[a] > weights_[b] : a < b;
  };
  const int kept = std::min(count_, kTopLabels);
  std::partial_sort(used_.begin(), used_.begin() + kept, used_.begin() + count_, heavier);
  LabelDistribution top;
  for (int i = 0; i < kept; ++i) {
    top.labels[i] = used_[i];
    top.probabilities[i] =
        static_cast<float>(static_cast<double>(weights_[used_[i]]) / static_cast<double>(total));
  }
  for (int i = 0; i < count_; ++i) weights_[used_[i]] = 0;
  count_ = 0;
  return top;
}

CompactLabels::CompactLabels(const LabelDistribution& distribution) {
  const int observations = std::clamp(distribution.observations, 0, kMaxObservations);
  int left = kProbabilityOne;
  for (int i = 0; i < kTopLabels; ++i) {
    const auto rounded =
        static_cast<int>(std::lround(distribution.probabilities[i] * kProbabilityOne));
    assert(rounded >= 0);
    const int probability = std::min(rounded, left);
    left -= probability;
    const int word = probability | (observations >> (2 * i) & 3) << 14;
    bytes_[2 * i] = static_cast<std::uint8_t>(word);
    bytes_[2 * i + 1] = static_cast<std::uint8_t>(word >> 8);
    bytes_[2 * kTopLabels + i] = distribution.labels[i];
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

void CompactLabels::AddTo(LabelSum& sum, std::uint64_t weight) const {
  for (int i = 0; i < kTopLabels; ++i) sum.Add(label(i), weight * scaled_probability(i));
}

}  // namespace semantic_slam
