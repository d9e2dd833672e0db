#include "semantic_slam/simulation/exposure.h"

#include <algorithm>

#include "semantic_slam/simulation/tone_curve.h"

namespace semantic_slam {
namespace {

constexpr float kDarkest = 4.0f;  // mean pixel; a darker image is as hard to light as that

}  // namespace

cv::Mat Expose(const cv::Mat& colour, const Eigen::Vector3f& gains_bgr) {
  const ToneCurve curve;
  cv::Mat table(1, 256, CV_8UC3);
  for (int pixel = 0; pixel < 256; ++pixel) {
    table.at<cv::Vec3b>(pixel) =
        curve.Pixel(ToneCurve::LightOf(static_cast<std::uint8_t>(pixel)) * gains_bgr);
  }
  cv::Mat exposed;
  cv::LUT(colour, table, exposed);
  return exposed;
}

float ExposureFor(const cv::Mat& colour, float mean_pixel) {
  const cv::Scalar mean = cv::mean(colour);
  const auto grey = static_cast<float>((mean[0] + mean[1] + mean[2]) / 3.0);
  const auto light = [](float pixel) {
    return ToneCurve::LightOf(static_cast<std::uint8_t>(pixel));
  };
  return light(mean_pixel) / light(std::max(grey, kDarkest));
}

}  // namespace semantic_slam
