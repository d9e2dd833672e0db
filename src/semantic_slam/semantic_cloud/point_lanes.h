#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "semantic_slam/common/lanes.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

namespace semantic_slam {

// The 32 bytes of a SemanticPoint as two vectors, for loops over whole clouds.
class PointLanes {
 public:
  explicit PointLanes(const SemanticPoint& point) {
    static_assert(sizeof(SemanticPoint) == 32 && offsetof(SemanticPoint, rgb) == 12 &&
                  offsetof(SemanticPoint, labels) == 15 &&
                  offsetof(SemanticPoint, confidences) == 20);
    const auto* const bytes = reinterpret_cast<const char*>(&point);
    std::memcpy(&low_, bytes, sizeof(low_));
    std::memcpy(&high_, bytes + sizeof(low_), sizeof(high_));
  }

  // x, y, z [m], and 0. What lies beside must go: as a number it would be one of those that are too
  // small for a processor's fast way.
  Floats4 position() const { return reinterpret_cast<Floats4>(Bits(low_) & Ints4{-1, -1, -1, 0}); }

  // Red, green, blue; the fourth number is not of the colour.
  Ints4 rgb() const {
    const std::uint32_t middle = Middle();
    Bytes4 bytes;
    std::memcpy(bytes.data(), &middle, sizeof(middle));
    return ToInts(bytes);
  }

  // The three labels in the lowest 24 bits, the first one in the lowest eight.
  std::uint32_t labels() const {
    return Middle() >> 24 | (static_cast<std::uint32_t>(Bits(high_)[0]) & 0xffff) << 8;
  }

  // 0, and the three confidences.
  Floats4 confidences() const {
    return reinterpret_cast<Floats4>(Bits(high_) & Ints4{0, -1, -1, -1});
  }

 private:
  static Ints4 Bits(Floats4 floats) { return reinterpret_cast<Ints4>(floats); }
  std::uint32_t Middle() const { return static_cast<std::uint32_t>(Bits(low_)[3]); }

  Floats4 low_;   // x y z, and r g b label
  Floats4 high_;  // label label - -, and three confidences
};

}  // namespace semantic_slam
