#include "semantic_slam/simulation/tone_curve.h"

#include <limits>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

int Grey(float light) {
  return ToneCurve().Pixel(Eigen::Vector3f::Constant(light))[1];
}

TEST(ToneCurveTest, GoesFromBlackToWhite) {
  EXPECT_EQ(Grey(0.0f), 0);
  EXPECT_EQ(Grey(-1.0f), 0);
  EXPECT_GT(Grey(1.0f), 215);
  EXPECT_GT(Grey(100.0f), 250);
  EXPECT_GT(Grey(std::numeric_limits<float>::infinity()), 250);
}

TEST(ToneCurveTest, LeavesOutNoGreyBelowWhite) {
  int before = 0;
  for (int i = 0; i <= 4000; ++i) {
    const int now = Grey(static_cast<float>(i) * static_cast<float>(i) * 1e-7f);
    EXPECT_GE(now, before);
    EXPECT_LE(now, before + 1);
    before = now;
  }
}

TEST(ToneCurveTest, ChannelsAreIndependent) {
  const ToneCurve curve;
  const cv::Vec3b pixel = curve.Pixel({0.0f, 0.1f, 1.0f});
  EXPECT_EQ(pixel[0], 0);
  EXPECT_EQ(pixel[1], Grey(0.1f));
  EXPECT_EQ(pixel[2], Grey(1.0f));
}

TEST(ToneCurveTest, PaintedWhiteThrowsBackAllAndGreyAQuarter) {
  EXPECT_FLOAT_EQ(ToneCurve::Linear({0.0f, 127.5f, 255.0f})[0], 0.0f);
  EXPECT_FLOAT_EQ(ToneCurve::Linear({0.0f, 127.5f, 255.0f})[1], 0.25f);
  EXPECT_FLOAT_EQ(ToneCurve::Linear({0.0f, 127.5f, 255.0f})[2], 1.0f);
}

}  // namespace
}  // namespace semantic_slam
