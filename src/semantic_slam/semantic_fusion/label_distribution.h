#pragma once

#include <array>
#include <cstdint>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {

// What is known of the class of one place: its most probable labels, and how many observations say
// so. What is missing to 1 belongs to all other classes together ("others" in thesis
// Algorithm 3.1).
struct LabelDistribution {
  std::array<LabelId, kTopLabels> labels{};  // by descending probability, kUnknownLabel at the end
  std::array<float, kTopLabels> probabilities{};  // their sum is at most 1
  int observations = 0;

  // Labels in use.
  int size() const;

  // The probability of all labels that are not listed.
  float others() const;

  // 0 for a label that is not listed.
  float Probability(LabelId label) const;

  // kUnknownLabel if nothing is known.
  LabelId top() const { return labels[0]; }
};

// A LabelDistribution in the nine bytes that an octree node has room for: three ids, three
// probabilities in steps of 1/16383 (a thirtieth of the smallest one that fusion keeps, 0.005), and
// the observations, which stop at 63, in the six bits left over. Bytes, because a node of 24 bytes
// has no room for alignment.
class CompactLabels {
 public:
  static constexpr int kProbabilityOne = 16383;
  static constexpr int kMaxObservations = 63;
  static constexpr int kBytes = 3 * kTopLabels;

  CompactLabels() = default;
  explicit CompactLabels(const LabelDistribution& distribution);

  // Of probabilities in units of 1/kProbabilityOne, descending; what makes their sum more than one
  // is taken from the last ones.
  CompactLabels(const std::array<LabelId, kTopLabels>& labels,
                const std::array<int, kTopLabels>& scaled_probabilities, int observations);

  // For files.
  static CompactLabels FromBytes(const std::array<std::uint8_t, kBytes>& bytes);
  const std::array<std::uint8_t, kBytes>& bytes() const { return bytes_; }

  // False for bytes that no distribution has: probabilities of a sum over 1, not descending, or of
  // labels that are not there.
  bool IsValid() const;

  LabelDistribution Unpacked() const;

  LabelId label(int i) const { return bytes_[2 * kTopLabels + i]; }
  int scaled_probability(int i) const { return Word(i) & kProbabilityOne; }
  int observations() const { return Word(0) >> 14 | (Word(1) >> 14) << 2 | (Word(2) >> 14) << 4; }

  friend bool operator==(const CompactLabels& a, const CompactLabels& b) {
    return a.bytes_ == b.bytes_;
  }
  friend bool operator!=(const CompactLabels& a, const CompactLabels& b) { return !(a == b); }

 private:
  int Word(int i) const { return bytes_[2 * i] | bytes_[2 * i + 1] << 8; }

  std::array<std::uint8_t, kBytes> bytes_{};  // three little-endian words, three ids
};

static_assert(sizeof(CompactLabels) == CompactLabels::kBytes && alignof(CompactLabels) == 1,
              "no padding: the octree's node counts on it");

}  // namespace semantic_slam
