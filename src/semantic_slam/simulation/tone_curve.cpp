#include "semantic_slam/simulation/tone_curve.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr double kExposure = 1.3;

}  // namespace

ToneCurve::ToneCurve() {
  for (int i = 0; i < kSteps; ++i) {
    const double root = std::sqrt(kBrightest) * i / (kSteps - 1);
    const double share = 1.0 - std::exp(-kExposure * root * root);
    bytes_[i] = static_cast<std::uint8_t>(std::lround(255.0 * std::sqrt(share)));
  }
}

float ToneCurve::LightOf(std::uint8_t pixel) {
  const double root = std::min<double>(pixel, 254.5) / 255.0;
  return static_cast<float>(-std::log(1.0 - root * root) / kExposure);
}

std::uint8_t ToneCurve::Byte(float light) const {
  const float root = std::sqrt(std::clamp(light / kBrightest, 0.0f, 1.0f));
  return bytes_[static_cast<int>(root * (kSteps - 1) + 0.5f)];
}

}  // namespace semantic_slam
