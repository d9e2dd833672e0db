#include "semantic_slam/control/thrust_direction.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {
namespace {

const QuadrotorParameters kQuadrotor;
const ThrustLimits kLimits;

Eigen::Vector3d Limited(double x, double y, double z) {
  return LimitedAcceleration({x, y, z}, kQuadrotor, kLimits);
}

TEST(LimitedAccelerationTest, LeavesWhatIsPossible) {
  EXPECT_TRUE(Limited(1.0, -2.0, 3.0).isApprox(Eigen::Vector3d(1, -2, 3)));
}

TEST(LimitedAccelerationTest, KeepsTheTiltWithinItsLimit) {
  const Eigen::Vector3d limited = Limited(30.0, 40.0, 0.0);
  EXPECT_NEAR(limited.head<2>().norm(), 9.81 * std::tan(M_PI / 6), 1e-9);
  EXPECT_NEAR(limited.y() / limited.x(), 4.0 / 3.0, 1e-12);
  EXPECT_NEAR(limited.z(), 0.0, 1e-12);
}

TEST(LimitedAccelerationTest, HeightComesFirst) {
  const double most = 0.8 * kQuadrotor.max_thrust_n() / kQuadrotor.mass_kg();
  const Eigen::Vector3d limited = Limited(10.0, 0.0, 100.0);
  EXPECT_NEAR(limited.z(), most - 9.81, 1e-9);
  EXPECT_NEAR(limited.x(), 0.0, 1e-6);  // the root of a difference that rounds
}

TEST(LimitedAccelerationTest, NeverFallsFreely) {
  EXPECT_NEAR(Limited(0.0, 0.0, -100.0).z(), -0.7 * 9.81, 1e-12);
}

TEST(ToAttitudeTest, StandingStillIsLevelAtTheHeading) {
  const AttitudeCommand command = ToAttitude(Eigen::Vector3d::Zero(), 2.0, 0.5, 0.816);
  EXPECT_TRUE(command.R_world_desired.isApprox(ExpSo3({0, 0, 2.0})));
  EXPECT_NEAR(command.thrust_n, 0.816 * 9.81, 1e-12);
  EXPECT_TRUE(command.angular_velocity_radps.isApprox(Eigen::Vector3d(0, 0, 0.5)));
}

TEST(ToAttitudeTest, ThrustAndGravityGiveTheAcceleration) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> some(-3.0, 3.0);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d wanted(some(random), some(random), some(random));
    const double yaw = some(random);
    const AttitudeCommand command = ToAttitude(wanted, yaw, 0.0, 2.0);
    const Eigen::Matrix3d& R = command.R_world_desired;
    EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
    const Eigen::Vector3d given =
        R.col(2) * command.thrust_n / 2.0 - Eigen::Vector3d(0, 0, kGravityMps2);
    EXPECT_LT((given - wanted).norm(), 1e-12);
    // The x axis has the heading: it is in the vertical plane through it.
    const Eigen::Vector3d across(-std::sin(yaw), std::cos(yaw), 0.0);
    EXPECT_NEAR(R.col(2)
                    .cross(Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0.0))
                    .normalized()
                    .dot(R.col(1)),
                1.0, 1e-12);
    EXPECT_GT(R.col(1).dot(across), 0.0);
  }
}

}  // namespace
}  // namespace semantic_slam
