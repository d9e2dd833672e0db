#include "semantic_slam/simulation/exposure.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const cv::Mat kGrey(4, 4, CV_8UC3, cv::Scalar(100, 100, 100));

TEST(Exposure, ChangesNothingWithGainsOfOne) {
  const cv::Mat exposed = Expose(kGrey, Eigen::Vector3f::Ones());
  EXPECT_LE(cv::norm(exposed, kGrey, cv::NORM_INF), 1.0);  // the curve's table has steps
}

TEST(Exposure, BrightensAndTintsByTheGains) {
  const cv::Vec3b pixel = Expose(kGrey, {1.0f, 2.0f, 0.5f}).at<cv::Vec3b>(0, 0);
  EXPECT_GT(pixel[1], 125);
  EXPECT_LT(pixel[2], 80);
}

TEST(Exposure, ReachesTheMeanThatWasAskedFor) {
  const float gain = ExposureFor(kGrey, 150.0f);
  const cv::Vec3b pixel = Expose(kGrey, Eigen::Vector3f::Constant(gain)).at<cv::Vec3b>(0, 0);
  EXPECT_NEAR(pixel[0], 150, 1);  // the curve's table has steps
}

TEST(Exposure, IsFiniteForBlack) {
  EXPECT_LT(ExposureFor(cv::Mat(2, 2, CV_8UC3, cv::Scalar(0, 0, 0)), 150.0f), 1e5f);
}

}  // namespace
}  // namespace semantic_slam
