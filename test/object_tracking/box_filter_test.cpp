#include "semantic_slam/object_tracking/box_filter.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

namespace semantic_slam {
namespace {

const cv::Rect2f kBox(100, 200, 40, 80);

TEST(BoxFilterTest, BeginsAtTheMeasuredBoxWithTheNoiseOfItsSize) {
  const BoxFilter filter(kBox, {});
  BoxFilter::State expected;
  expected << 120, 240, 40, 80, 0, 0, 0, 0;
  EXPECT_EQ(filter.state(), expected);
  // 2 x 1/20 of width or height for the position, 10 x 1/160 for the velocity (BoT-SORT).
  EXPECT_DOUBLE_EQ(filter.covariance()(0, 0), 4.0 * 4.0);
  EXPECT_DOUBLE_EQ(filter.covariance()(3, 3), 8.0 * 8.0);
  EXPECT_DOUBLE_EQ(filter.covariance()(4, 4), 2.5 * 2.5);
  EXPECT_DOUBLE_EQ(filter.covariance()(7, 7), 5.0 * 5.0);
}

TEST(BoxFilterTest, FollowsConstantVelocity) {
  BoxFilter filter(kBox, {});
  for (int i = 1; i <= 40; ++i) {
    filter.Predict(false);
    filter.Correct(kBox + cv::Point2f(5.0f * i, -3.0f * i));
  }
  filter.Predict(false);
  // Without noise in the measurements the filter converges to the truth.
  EXPECT_NEAR(filter.box().x, 100 + 5 * 41, 0.1);
  EXPECT_NEAR(filter.box().y, 200 - 3 * 41, 0.1);
  EXPECT_NEAR(filter.state()[4], 5.0, 0.05);
  EXPECT_NEAR(filter.state()[5], -3.0, 0.05);
}

TEST(BoxFilterTest, OneStepAgreesWithTheTextbook) {
  BoxFilter filter(kBox, {});
  filter.Predict(false);
  // Per axis (x): P = 16 + 6.25 after the step, plus process noise 2^2; the same noise measures.
  const double P = 4.0 * 4.0 + 2.5 * 2.5 + 2.0 * 2.0;
  EXPECT_NEAR(filter.covariance()(0, 0), P, 1e-12);
  filter.Correct(kBox + cv::Point2f(10, 0));
  EXPECT_NEAR(filter.state()[0], 120.0 + 10.0 * P / (P + 4.0), 1e-9);
  EXPECT_NEAR(filter.covariance()(0, 0), P * 4.0 / (P + 4.0), 1e-9);
}

TEST(BoxFilterTest, OutOfSightTheSizeStays) {
  BoxFilter filter(kBox, {});
  for (int i = 1; i <= 5; ++i) {
    filter.Predict(false);
    filter.Correct({100, 200, 40.0f + 10 * i, 80.0f + 10 * i});
  }
  const cv::Rect2f last = filter.box();
  for (int i = 0; i < 30; ++i) filter.Predict(true);
  EXPECT_FLOAT_EQ(filter.box().width, last.width);
  EXPECT_FLOAT_EQ(filter.box().height, last.height);
}

TEST(BoxFilterTest, ABoxThatShrinksNeverVanishes) {
  BoxFilter filter(kBox, {});
  for (int i = 1; i <= 7; ++i) {
    filter.Predict(false);
    filter.Correct({100, 200, 40.0f - 5 * i, 80.0f - 10 * i});
  }
  for (int i = 0; i < 20; ++i) filter.Predict(false);
  EXPECT_GE(filter.box().width, 1.0f);
  EXPECT_GE(filter.box().height, 1.0f);
  EXPECT_TRUE(filter.covariance().allFinite());
}

TEST(BoxFilterTest, TheCamerasMotionMovesTurnsAndScales) {
  BoxFilter filter(kBox, {});
  ImageMotion motion;
  motion << 0, -2, 7,  // a quarter turn, twice as large, shifted
      2, 0, -3;
  filter.Warp(motion);
  EXPECT_DOUBLE_EQ(filter.state()[0], -2 * 240 + 7);
  EXPECT_DOUBLE_EQ(filter.state()[1], 2 * 120 - 3);
  EXPECT_DOUBLE_EQ(filter.covariance()(0, 0), 4 * 8.0 * 8.0);
  EXPECT_DOUBLE_EQ(filter.covariance()(1, 1), 4 * 4.0 * 4.0);
}

TEST(BoxFilterTest, TheCovarianceStaysPositive) {
  BoxFilter filter(kBox, {});
  for (int i = 0; i < 1000; ++i) {
    filter.Predict(i % 7 == 0);
    if (i % 3 == 0) filter.Correct(kBox);
  }
  const Eigen::SelfAdjointEigenSolver<BoxFilter::Covariance> solver(filter.covariance());
  EXPECT_GT(solver.eigenvalues().minCoeff(), 0.0);
}

}  // namespace
}  // namespace semantic_slam
