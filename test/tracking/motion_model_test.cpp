#include "semantic_slam/tracking/motion_model.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr Stamp kStart{1'000'000'000};

Stamp After(double seconds) {
  return {kStart.ns + static_cast<std::int64_t>(seconds * 1e9)};
}

// 0.1 m forward and 0.2 rad about the vertical.
Rigid3d Motion(double times = 1.0) {
  Rigid3d T = Rigid3d::Identity();
  T.translation() = times * Eigen::Vector3d(0.0, 0.0, 0.1);
  T.linear() = ExpSo3(times * Eigen::Vector3d(0.0, 0.2, 0.0));
  return T;
}

TEST(MotionModelTest, KnowsNothingAtFirst) {
  EXPECT_TRUE(MotionModel().Predict(kStart, After(0.1)).isApprox(Rigid3d::Identity()));
}

TEST(MotionModelTest, StretchesTheLastMotionToTheTimePassed) {
  MotionModel model;
  model.Update(kStart, After(0.1), Motion());
  EXPECT_TRUE(model.Predict(After(0.1), After(0.2)).isApprox(Motion(), 1e-9));
  EXPECT_TRUE(model.Predict(After(0.1), After(0.3)).isApprox(Motion(2.0), 1e-9));
  EXPECT_TRUE(model.Predict(After(0.1), After(0.15)).isApprox(Motion(0.5), 1e-9));
}

TEST(MotionModelTest, ACameraAtRestStaysThere) {
  MotionModel model;
  model.Update(kStart, After(0.1), Rigid3d::Identity());
  EXPECT_TRUE(model.Predict(After(0.1), After(0.3)).isApprox(Rigid3d::Identity()));
}

TEST(MotionModelTest, AnOldVelocitySaysNothing) {
  MotionModel model;
  model.Update(kStart, After(0.1), Motion());
  EXPECT_FALSE(model.Predict(After(0.1), After(0.59)).isApprox(Rigid3d::Identity()));
  EXPECT_TRUE(model.Predict(After(0.1), After(0.61)).isApprox(Rigid3d::Identity()));
  model.Update(kStart, After(0.6), Motion());  // nor one over a long gap
  EXPECT_TRUE(model.Predict(After(0.6), After(0.7)).isApprox(Rigid3d::Identity()));
}

TEST(MotionModelTest, TimeThatDoesNotGrowSaysNothing) {
  MotionModel model;
  model.Update(kStart, kStart, Motion());
  EXPECT_TRUE(model.Predict(kStart, After(0.1)).isApprox(Rigid3d::Identity()));
  model.Update(kStart, After(0.1), Motion());
  EXPECT_TRUE(model.Predict(After(0.1), After(0.1)).isApprox(Rigid3d::Identity()));
  EXPECT_TRUE(model.Predict(After(0.1), kStart).isApprox(Rigid3d::Identity()));
}

TEST(MotionModelTest, ResetForgets) {
  MotionModel model;
  model.Update(kStart, After(0.1), Motion());
  model.Reset();
  EXPECT_TRUE(model.Predict(After(0.1), After(0.2)).isApprox(Rigid3d::Identity()));
}

TEST(MotionModelTest, TheTwistIsThatOfThePrediction) {
  MotionModel model;
  EXPECT_TRUE(model.Twist(kStart, After(0.1)).velocity_mps.isZero());
  model.Update(kStart, After(0.1), Motion());
  const CameraTwist twist = model.Twist(After(0.1), After(0.3));
  EXPECT_TRUE(twist.angular_velocity_radps.isApprox(Eigen::Vector3d(0.0, 2.0, 0.0), 1e-9));
  // In the axes that the camera has in the end: turned by 0.4 rad against where it set out for.
  EXPECT_TRUE(twist.velocity_mps.isApprox(
      ExpSo3(Eigen::Vector3d(0.0, -0.4, 0.0)) * Eigen::Vector3d(0.0, 0.0, 1.0), 1e-9));
}

TEST(MeanTwistTest, WithoutTimeThereIsNone) {
  EXPECT_TRUE(MeanTwist(Motion(), 0.0).velocity_mps.isZero());
  EXPECT_TRUE(MeanTwist(Motion(), -1.0).angular_velocity_radps.isZero());
}

}  // namespace
}  // namespace semantic_slam
