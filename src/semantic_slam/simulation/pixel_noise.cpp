#include "semantic_slam/simulation/pixel_noise.h"

#include <cmath>

namespace semantic_slam {
namespace {

// Where the normal distribution function is `share`, by bisection.
double NormalQuantile(double share) {
  double low = -8.0, high = 8.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < share ? low : high) = middle;
  }
  return low;
}

}  // namespace

const std::array<float, PixelNoise::kQuantiles>& PixelNoise::Quantiles() {
  static const std::array<float, kQuantiles> kTable = [] {
    std::array<float, kQuantiles> table{};
    for (int i = 0; i < kQuantiles; ++i) {
      table[i] = static_cast<float>(NormalQuantile((i + 0.5) / kQuantiles));
    }
    return table;
  }();
  return kTable;
}

}  // namespace semantic_slam
