#include "semantic_slam/control/attitude_command.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {
namespace {

Eigen::Matrix3d AboutZ(double angle) {
  return ExpSo3({0.0, 0.0, angle});
}

TEST(AttitudeCommandTest, TurnsOnWithItsVelocity) {
  AttitudeCommand command;
  command.R_world_desired = AboutZ(1.0);
  command.angular_velocity_radps << 0.0, 0.0, 0.5;
  EXPECT_TRUE(After(command, 2.0).R_world_desired.isApprox(AboutZ(2.0)));
}

TEST(AttitudeCommandTest, LevelKeepsTheHeading) {
  const Eigen::Matrix3d tilted = AboutZ(2.5) * ExpSo3({0.3, 0.4, 0.0});
  const AttitudeCommand command = LevelCommand(tilted, 7.0);
  EXPECT_EQ(command.thrust_n, 7.0);
  EXPECT_TRUE(command.R_world_desired.isApprox(AboutZ(Heading(tilted))));
  EXPECT_TRUE(command.angular_velocity_radps.isZero());
}

TEST(AttitudeCommandTest, HeadingIsThatOfTheXAxis) {
  EXPECT_NEAR(Heading(AboutZ(-2.0) * ExpSo3({0.0, 0.5, 0.0})), -2.0, 1e-12);
  EXPECT_EQ(Heading(Eigen::Matrix3d::Identity()), 0.0);
}

TEST(AttitudeCommandTest, WrapsAnglesToHalfATurn) {
  EXPECT_NEAR(WrappedAngle(M_PI + 0.1), -M_PI + 0.1, 1e-12);
  EXPECT_NEAR(WrappedAngle(-7.0 * M_PI + 0.1), -M_PI + 0.1, 1e-12);
  EXPECT_EQ(WrappedAngle(1.0), 1.0);
}

}  // namespace
}  // namespace semantic_slam
