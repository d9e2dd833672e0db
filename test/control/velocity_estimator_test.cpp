#include "semantic_slam/control/velocity_estimator.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kStepS = 1.0 / 30.0;
const Eigen::Vector3d kNothing = Eigen::Vector3d::Zero();

// Swings along x: 1 m, with a period of some 6 s.
Eigen::Vector3d SwingPosition(double t) {
  return {std::sin(t), 0, 0};
}
Eigen::Vector3d SwingVelocity(double t) {
  return {std::cos(t), 0, 0};
}
Eigen::Vector3d SwingAcceleration(double t) {
  return {-std::sin(t), 0, 0};
}

TEST(VelocityEstimatorTest, BeginsAtRest) {
  VelocityEstimator estimator;
  estimator.Restart({1, 2, 3});
  EXPECT_EQ(estimator.velocity_mps(), kNothing);
}

TEST(VelocityEstimatorTest, FindsAConstantVelocity) {
  VelocityEstimator estimator;
  estimator.Restart(kNothing);
  const Eigen::Vector3d velocity(0.5, -0.2, 0.1);
  for (int i = 1; i <= 150; ++i) estimator.Update(i * kStepS * velocity, kNothing, kStepS);
  EXPECT_LT((estimator.velocity_mps() - velocity).norm(), 1e-3);
}

TEST(VelocityEstimatorTest, FindsAVelocityThroughNoise) {
  VelocityEstimator estimator;
  estimator.Restart(kNothing);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.005);
  double squares = 0.0, raw_squares = 0.0;
  Eigen::Vector3d last = kNothing;
  for (int i = 1; i <= 600; ++i) {
    const double t = i * kStepS;
    const Eigen::Vector3d measured =
        SwingPosition(t) + Eigen::Vector3d(noise(random), noise(random), noise(random));
    ASSERT_TRUE(estimator.Update(measured, SwingAcceleration(t - kStepS / 2), kStepS));
    if (i > 60) {
      squares += (estimator.velocity_mps() - SwingVelocity(t)).squaredNorm();
      raw_squares += ((measured - last) / kStepS - SwingVelocity(t)).squaredNorm();
    }
    last = measured;
  }
  // 5 mm of noise differentiated are 0.2 m/s per axis; the filter leaves a sixth of that at most.
  EXPECT_LT(std::sqrt(squares), std::sqrt(raw_squares) / 6.0);
}

TEST(VelocityEstimatorTest, LearnsAnAccelerationThatNobodyTold) {
  VelocityEstimator estimator;
  estimator.Restart(kNothing);
  double t = 0.0;
  for (int i = 1; i <= 150; ++i) {
    t = i * kStepS;
    estimator.Update({0.5 * 0.4 * t * t, 0, 0}, kNothing, kStepS);
  }
  EXPECT_NEAR(estimator.velocity_mps().x(), 0.4 * t, 0.01);
}

TEST(VelocityEstimatorTest, AJumpOfThePositionIsNoVelocity) {
  VelocityEstimator estimator;
  estimator.Restart(kNothing);
  const Eigen::Vector3d velocity(0.5, 0, 0), jump(2, -3, 1);
  for (int i = 1; i <= 150; ++i) estimator.Update(i * kStepS * velocity, kNothing, kStepS);
  EXPECT_FALSE(estimator.Update(151 * kStepS * velocity + jump, kNothing, kStepS));
  for (int i = 152; i <= 160; ++i) {
    EXPECT_TRUE(estimator.Update(i * kStepS * velocity + jump, kNothing, kStepS));
    EXPECT_LT((estimator.velocity_mps() - velocity).norm(), 0.01);
  }
}

TEST(VelocityEstimatorTest, RefusesOptionsOutOfRange) {
  VelocityEstimatorOptions options;
  options.position_sigma_m = 0.0;
  EXPECT_THROW(VelocityEstimator{options}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
