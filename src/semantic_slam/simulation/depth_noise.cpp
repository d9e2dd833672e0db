#include "semantic_slam/simulation/depth_noise.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "semantic_slam/common/options.h"

namespace semantic_slam {
namespace {

constexpr float kNoReturn = std::numeric_limits<float>::quiet_NaN();
constexpr float kHidingStepPx = 1.0f;  // what hides something is nearer by that at least

// Which pixels of a row the second camera, to the right of the first, cannot see: something nearer
// lies where they are in its image. A pixel u of disparity d is at u - d there.
class HiddenPixels {
 public:
  HiddenPixels(const float* disparity_px, int columns)
      : disparity_px_(disparity_px), columns_(columns), nearest_px_(columns + 1, 0.0f) {
    for (int u = 0; u < columns; ++u) {
      const int at = ColumnOf(u);
      if (at < 0) continue;
      for (const int column : {at, at + 1}) {
        nearest_px_[column] = std::max(nearest_px_[column], disparity_px[u]);
      }
    }
  }

  bool operator()(int u) const {
    const int at = ColumnOf(u);
    return at >= 0 &&
           std::min(nearest_px_[at], nearest_px_[at + 1]) > disparity_px_[u] + kHidingStepPx;
  }

 private:
  // In the second image, rounded down; -1 if that is not in it or there is no disparity.
  int ColumnOf(int u) const {
    const float at = static_cast<float>(u) - disparity_px_[u];
    return at >= 0.0f && at < static_cast<float>(columns_) ? static_cast<int>(at) : -1;
  }

  const float* disparity_px_;
  int columns_;
  std::vector<float> nearest_px_;
};

}  // namespace

DepthNoise::DepthNoise(const DepthNoiseOptions& options, double focal_length_px)
    : options_(Validated(options)),
      focal_baseline_(static_cast<float>(focal_length_px * options.baseline_m)) {}

cv::Mat DepthNoise::Apply(const cv::Mat& depth_m, const cv::Mat& incidence, Stamp stamp) const {
  assert(depth_m.type() == CV_32FC1 && incidence.type() == CV_32FC1 &&
         depth_m.size() == incidence.size());
  if (!options_.noise) return depth_m.clone();
  const PixelNoise random(static_cast<std::uint64_t>(options_.seed), stamp);
  const cv::Mat disparity_px = focal_baseline_ / depth_m;
  cv::Mat noisy_m(depth_m.size(), CV_32FC1);
  cv::parallel_for_({0, depth_m.rows}, [&](const cv::Range& range) {
    for (int v = range.start; v < range.end; ++v) {
      ApplyToRow(v, disparity_px, incidence, random, noisy_m);
    }
  });
  return noisy_m;
}

void DepthNoise::ApplyToRow(int v, const cv::Mat& disparity_px, const cv::Mat& incidence,
                            const PixelNoise& random, cv::Mat& noisy_m) const {
  const auto* const row = disparity_px.ptr<float>(v);
  const HiddenPixels is_hidden(row, disparity_px.cols);
  const auto blind = static_cast<float>(options_.blind_cosine);
  const auto clear = static_cast<float>(options_.clear_cosine);
  for (int u = 0; u < disparity_px.cols; ++u) {
    const std::uint64_t bits = random.Bits(static_cast<std::uint64_t>(v) * disparity_px.cols + u);
    // Between blind and clear the cosine decides how many returns fail.
    const float least_cosine = blind + PixelNoise::Uniform(bits) * (clear - blind);
    float& noisy = noisy_m.at<float>(v, u);
    noisy = kNoReturn;
    if (std::isnan(row[u]) || incidence.at<float>(v, u) < least_cosine || is_hidden(u)) continue;
    const auto chance = static_cast<float>(FractionOf(Mixed(bits)));
    if (chance < options_.edge_dropout_probability && IsAtEdge(disparity_px, v, u)) continue;
    noisy = Measured(row[u], PixelNoise::Gaussian(bits, 0));
  }
}

bool DepthNoise::IsAtEdge(const cv::Mat& disparity_px, int v, int u) const {
  const float here = disparity_px.at<float>(v, u);
  const auto steps_at = [&](int row, int column) {
    const cv::Rect image(cv::Point(), disparity_px.size());
    return image.contains({column, row}) &&
           !(std::abs(disparity_px.at<float>(row, column) - here) <= options_.edge_step_px);
  };
  return steps_at(v, u - 1) || steps_at(v, u + 1) || steps_at(v - 1, u) || steps_at(v + 1, u);
}

float DepthNoise::Measured(float disparity_px, float gaussian) const {
  float measured_px = disparity_px + static_cast<float>(options_.disparity_sigma_px) * gaussian;
  const auto step_px = static_cast<float>(options_.disparity_step_px);
  if (step_px > 0.0f) measured_px = std::round(measured_px / step_px) * step_px;
  const float depth_m = focal_baseline_ / measured_px;
  const bool in_range = depth_m >= options_.min_depth_m && depth_m <= options_.max_depth_m;
  return in_range ? depth_m : kNoReturn;
}

}  // namespace semantic_slam
