#include "semantic_slam/simulation/colour_noise.h"

#include <cassert>
#include <cmath>

#include "semantic_slam/common/options.h"
#include "semantic_slam/simulation/pixel_noise.h"

namespace semantic_slam {
namespace {

static_assert(PixelNoise::kGaussians >= 3);  // one per channel

// What is left of light at a place of the image by vignetting: the square of the distance from its
// middle counts.
class Vignette {
 public:
  Vignette(cv::Size size, double loss)
      : middle_u_(0.5f * static_cast<float>(size.width - 1)),
        middle_v_(0.5f * static_cast<float>(size.height - 1)),
        loss_per_px2_(static_cast<float>(loss) /
                      std::max(middle_u_ * middle_u_ + middle_v_ * middle_v_, 1.0f)) {}

  float operator()(int v, int u) const {
    const float x = static_cast<float>(u) - middle_u_, y = static_cast<float>(v) - middle_v_;
    return 1.0f - loss_per_px2_ * (x * x + y * y);
  }

 private:
  float middle_u_, middle_v_, loss_per_px2_;
};

}  // namespace

ColourNoise::ColourNoise(const ColourNoiseOptions& options) : options_(Validated(options)) {
  for (std::size_t value = 0; value < sigma_.size(); ++value) {
    const double shot = options_.shot_sigma * std::sqrt(static_cast<double>(value) / 255.0);
    sigma_[value] = static_cast<float>(std::hypot(options_.read_sigma, shot));
  }
}

cv::Mat ColourNoise::Apply(const cv::Mat& colour, Stamp stamp) const {
  assert(colour.type() == CV_8UC3);
  if (!options_.noise) return colour.clone();
  const PixelNoise random(static_cast<std::uint64_t>(options_.seed), stamp);
  const Vignette vignette(colour.size(), options_.vignetting);
  cv::Mat noisy(colour.size(), CV_8UC3);
  cv::parallel_for_({0, colour.rows}, [&](const cv::Range& range) {
    for (int v = range.start; v < range.end; ++v) {
      const auto* const exact = colour.ptr<cv::Vec3b>(v);
      auto* const row = noisy.ptr<cv::Vec3b>(v);
      for (int u = 0; u < colour.cols; ++u) {
        const std::uint64_t bits = random.Bits(static_cast<std::uint64_t>(v) * colour.cols + u);
        const float left = vignette(v, u);
        for (int c = 0; c < 3; ++c) {
          row[u][c] = cv::saturate_cast<std::uint8_t>(
              left * exact[u][c] + sigma_[exact[u][c]] * PixelNoise::Gaussian(bits, c));
        }
      }
    }
  });
  return noisy;
}

}  // namespace semantic_slam
