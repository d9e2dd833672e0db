#pragma once

#include <cstdint>
#include <limits>

namespace semantic_slam {

// part / all, 0..1; NaN of nothing.
inline double ShareOf(std::int64_t part, std::int64_t all) {
  if (all == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace semantic_slam
