#include "semantic_slam/simulation/colour_noise.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

cv::Mat Grey(int value) {
  return cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(value));
}

bool SamePixels(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0.0;
}

ColourNoiseOptions WithoutVignetting() {
  ColourNoiseOptions options;
  options.vignetting = 0.0;
  return options;
}

TEST(ColourNoiseTest, GrowsWithLight) {
  const ColourNoiseOptions options = WithoutVignetting();
  for (const int value : {20, 100, 200}) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(ColourNoise(options).Apply(Grey(value), Stamp{1}), mean, deviation);
    const double shot = options.shot_sigma * std::sqrt(value / 255.0);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(mean[c], value, 0.1);
      // Rounding adds 1/12; five standard deviations from 19200 pixels are 2.6 %.
      const double expected =
          std::sqrt(options.read_sigma * options.read_sigma + shot * shot + 1.0 / 12.0);
      EXPECT_NEAR(deviation[c], expected, 0.03 * expected) << value;
    }
  }
}

TEST(ColourNoiseTest, CornersAreDarker) {
  ColourNoiseOptions options;
  options.read_sigma = options.shot_sigma = 0.0;
  options.vignetting = 0.2;
  const cv::Mat noisy = ColourNoise(options).Apply(Grey(200), Stamp{1});
  EXPECT_EQ(noisy.at<cv::Vec3b>(0, 0)[1], 160);
  EXPECT_EQ(noisy.at<cv::Vec3b>(119, 159)[1], 160);
  EXPECT_EQ(noisy.at<cv::Vec3b>(60, 80)[1], 200);
}

TEST(ColourNoiseTest, WithoutNoiseColourIsExact) {
  ColourNoiseOptions options;
  options.noise = false;
  const cv::Mat colour = Grey(77);
  const cv::Mat same = ColourNoise(options).Apply(colour, Stamp{1});
  EXPECT_TRUE(SamePixels(same, colour));
  EXPECT_NE(same.data, colour.data);
}

TEST(ColourNoiseTest, SeedAndStampDecideNotTheCores) {
  const auto apply = [](int seed, Stamp stamp) {
    ColourNoiseOptions options;
    options.seed = seed;
    return ColourNoise(options).Apply(Grey(128), stamp);
  };
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const cv::Mat one = apply(1, Stamp{5});
  cv::setNumThreads(2);
  const cv::Mat two = apply(1, Stamp{5});
  cv::setNumThreads(threads);
  EXPECT_TRUE(SamePixels(one, two));
  EXPECT_FALSE(SamePixels(one, apply(2, Stamp{5})));
  EXPECT_FALSE(SamePixels(one, apply(1, Stamp{6})));
}

TEST(ColourNoiseTest, RefusesOptionsOutOfRange) {
  ColourNoiseOptions options;
  options.vignetting = 1.5;
  EXPECT_NE(MessageOf<ConfigError>([&] { ColourNoise noise(options); }).find("vignetting"),
            std::string::npos);
}

}  // namespace
}  // namespace semantic_slam
