#pragma once

#include <array>
#include <cstdint>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// Random numbers for the pixels of one image: each pixel has its own, in whatever order they are
// worked on. Immutable, so safe from any thread.
class PixelNoise {
 public:
  // Deviates of the normal distribution with mean 0 and deviation 1 per set of bits.
  static constexpr int kGaussians = 4;

  // Other seeds and other stamps give other numbers.
  PixelNoise(std::uint64_t seed, Stamp stamp)
      : hash_(HashOf({seed, static_cast<std::uint64_t>(stamp.ns)})) {}

  // 64 random bits of a pixel.
  std::uint64_t Bits(std::uint64_t pixel) const { return Mixed(hash_ ^ pixel); }

  // The `i`-th of kGaussians numbers that a pixel's bits stand for, independent of one another.
  static float Gaussian(std::uint64_t bits, int i) {
    return Quantiles()[(bits >> (12 * i)) & (kQuantiles - 1)];
  }

  // 0 <= u < 1, of those bits that Gaussian() does not use.
  static float Uniform(std::uint64_t bits) { return static_cast<float>(bits >> 48) * 0x1.0p-16f; }

 private:
  static constexpr int kQuantiles = 4096;

  // Of the normal distribution: the middles of equally probable intervals.
  static const std::array<float, kQuantiles>& Quantiles();

  std::uint64_t hash_;
};

}  // namespace semantic_slam
