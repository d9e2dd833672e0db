#include "semantic_slam/simulation/depth_noise.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr double kFocalLengthPx = 384.0;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const cv::Size kSize(320, 120);

cv::Mat Filled(float value) {
  return cv::Mat(kSize, CV_32FC1, cv::Scalar(value));
}

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

double MissingShare(const cv::Mat& depth_m) {
  return 1.0 - cv::countNonZero(depth_m == depth_m) / static_cast<double>(depth_m.total());
}

// Only noise and range are left.
DepthNoiseOptions OnAPlainWall() {
  DepthNoiseOptions options;
  options.disparity_step_px = 0.0;
  return options;
}

class DepthOfAWall : public testing::TestWithParam<float> {};

TEST_P(DepthOfAWall, SpreadsWithTheSquareOfDepth) {
  const float depth_m = GetParam();
  const DepthNoiseOptions options = OnAPlainWall();
  const cv::Mat noisy_m =
      DepthNoise(options, kFocalLengthPx).Apply(Filled(depth_m), Filled(1.0f), Stamp{1});
  cv::Scalar mean, deviation;
  cv::meanStdDev(noisy_m, mean, deviation);
  const double expected_m =
      depth_m * depth_m / (kFocalLengthPx * options.baseline_m) * options.disparity_sigma_px;
  EXPECT_EQ(MissingShare(noisy_m), 0.0);
  // 3 %: five standard deviations of a deviation from 38400 pixels are 1.8 %; the reciprocal of a
  // disparity is not quite linear at 5 m.
  EXPECT_NEAR(deviation[0], expected_m, 0.03 * expected_m);
  EXPECT_NEAR(mean[0], depth_m, 0.05 * expected_m);
}

INSTANTIATE_TEST_SUITE_P(DepthNoiseTest, DepthOfAWall, testing::Values(0.8f, 2.0f, 5.0f));

TEST(DepthNoiseTest, DisparityComesInSteps) {
  DepthNoiseOptions options;
  options.disparity_sigma_px = 0.0;
  options.disparity_step_px = 0.25;
  cv::Mat depth_m(kSize, CV_32FC1);
  for (int v = 0; v < kSize.height; ++v) depth_m.row(v).setTo(1.0 + 0.01 * v);
  const cv::Mat noisy_m =
      DepthNoise(options, kFocalLengthPx).Apply(depth_m, Filled(1.0f), Stamp{1});
  for (int v = 0; v < kSize.height; ++v) {
    const double steps = kFocalLengthPx * options.baseline_m / noisy_m.at<float>(v, 60) / 0.25;
    EXPECT_NEAR(steps, std::round(steps), 1e-4);
    // Half a step of disparity.
    const double z = depth_m.at<float>(v, 60);
    EXPECT_NEAR(noisy_m.at<float>(v, 60), z, 1.05 * 0.125 * z * z / (kFocalLengthPx * 0.095));
  }
}

TEST(DepthNoiseTest, WithoutNoiseDepthIsExact) {
  DepthNoiseOptions options;
  options.noise = false;
  cv::Mat depth_m = Filled(7.5f);
  depth_m.at<float>(3, 4) = 0.1f;
  depth_m.at<float>(5, 6) = kNaN;
  const cv::Mat noisy_m =
      DepthNoise(options, kFocalLengthPx).Apply(depth_m, Filled(0.0f), Stamp{1});
  EXPECT_TRUE(SameBytes(noisy_m, depth_m));
  EXPECT_NE(noisy_m.data, depth_m.data);
}

TEST(DepthNoiseTest, NothingComesBackFromOutOfRange) {
  const DepthNoise noise(DepthNoiseOptions(), kFocalLengthPx);
  for (const float depth_m : {0.3f, 8.0f, kNaN}) {
    EXPECT_EQ(MissingShare(noise.Apply(Filled(depth_m), Filled(1.0f), Stamp{1})), 1.0) << depth_m;
  }
}

TEST(DepthNoiseTest, ReturnsFailAtGrazingIncidence) {
  const DepthNoise noise(DepthNoiseOptions(), kFocalLengthPx);
  const auto missing = [&](float cosine) {
    return MissingShare(noise.Apply(Filled(2.0f), Filled(cosine), Stamp{1}));
  };
  EXPECT_EQ(missing(0.3f), 0.0);
  EXPECT_NEAR(missing(0.15f), 0.5, 0.02);  // half way; five standard deviations are 1.3 %
  EXPECT_EQ(missing(0.04f), 1.0);
}

// A thing at 1 m, from column 200 on, before a wall at 2 m.
cv::Mat ThingBeforeAWall() {
  cv::Mat depth_m = Filled(2.0f);
  depth_m.colRange(200, kSize.width).setTo(1.0f);
  return depth_m;
}

double MissingIn(const cv::Mat& depth_m, int first, int last) {
  return MissingShare(depth_m.colRange(first, last + 1).clone());
}

TEST(DepthNoiseTest, TheWallLeftOfAThingIsHiddenFromTheOtherCamera) {
  DepthNoiseOptions options = OnAPlainWall();
  options.edge_dropout_probability = 0.0;
  const cv::Mat noisy_m =
      DepthNoise(options, kFocalLengthPx).Apply(ThingBeforeAWall(), Filled(1.0f), Stamp{1});
  // Disparities are 36.48 px and 18.24 px: the thing hides 18 columns of the wall.
  EXPECT_EQ(MissingIn(noisy_m, 183, 199), 1.0);
  EXPECT_EQ(MissingIn(noisy_m, 0, 180), 0.0);
  EXPECT_EQ(MissingIn(noisy_m, 200, kSize.width - 1), 0.0);
}

TEST(DepthNoiseTest, SomePixelsAtEdgesFailAndNoneLiesBetween) {
  const DepthNoise noise(DepthNoiseOptions(), kFocalLengthPx);
  double missing = 0.0;
  for (int i = 0; i < 10; ++i) {
    const cv::Mat noisy_m = noise.Apply(ThingBeforeAWall(), Filled(1.0f), Stamp{i});
    missing += 0.1 * MissingIn(noisy_m, 200, 200);
    EXPECT_EQ(MissingIn(noisy_m, 202, 300), 0.0);
    EXPECT_EQ(cv::countNonZero((noisy_m > 1.1f) & (noisy_m < 1.9f)), 0);
  }
  EXPECT_NEAR(missing, 0.5, 0.08);  // 1200 pixels: five standard deviations are 0.07
}

TEST(DepthNoiseTest, SeedAndStampDecideNotTheCores) {
  const auto apply = [](int seed, Stamp stamp) {
    DepthNoiseOptions options;
    options.seed = seed;
    return DepthNoise(options, kFocalLengthPx).Apply(ThingBeforeAWall(), Filled(0.2f), stamp);
  };
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const cv::Mat one = apply(1, Stamp{5});
  cv::setNumThreads(2);
  const cv::Mat two = apply(1, Stamp{5});
  cv::setNumThreads(threads);
  EXPECT_TRUE(SameBytes(one, two));
  EXPECT_FALSE(SameBytes(one, apply(2, Stamp{5})));
  EXPECT_FALSE(SameBytes(one, apply(1, Stamp{6})));
}

TEST(DepthNoiseTest, RefusesOptionsOutOfRange) {
  DepthNoiseOptions options;
  options.max_depth_m = 0.1;
  EXPECT_NE(MessageOf<ConfigError>([&] { DepthNoise(options, 384.0); }).find("max_depth_m"),
            std::string::npos);
}

}  // namespace
}  // namespace semantic_slam
