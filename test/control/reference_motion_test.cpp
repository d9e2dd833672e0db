#include "semantic_slam/control/reference_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/control/attitude_command.h"

namespace semantic_slam {
namespace {

constexpr double kStepS = 0.005;

ReferenceMotion Motion() {
  return ReferenceMotion({1.0, 0.5, 2.0});  // m/s^2, rad/s, rad/s^2
}

void Advance(ReferenceMotion& motion, const ReferenceTarget& target, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / kStepS));
  for (int i = 0; i < steps; ++i) motion.Advance(target, kStepS);
}

TEST(ReferenceMotionTest, StartsWhereItIsToldWithTheSpeedThatItIsTold) {
  ReferenceMotion motion = Motion();
  motion.StartFrom({1, 2, 3}, {0.1, 0, 0}, 0.5);
  EXPECT_EQ(motion.reference().position_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(motion.reference().velocity_mps, Eigen::Vector3d(0.1, 0, 0));
  EXPECT_EQ(motion.reference().yaw_rad, 0.5);
}

TEST(ReferenceMotionTest, KeepsItsLimits) {
  ReferenceMotion motion = Motion();
  motion.StartFrom({0, 0, 0}, {0, 0, 0}, 0.0);
  double last_rate = 0.0;
  Eigen::Vector3d last_acceleration = Eigen::Vector3d::Zero();
  for (int i = 0; i < 2000; ++i) {
    motion.Advance({{10, 5, 1}, 3.0, 0.8}, kStepS);
    const FlightReference& r = motion.reference();
    EXPECT_LE(r.velocity_mps.norm(), 0.8 * 1.05);  // the lag lets it swing over by a little
    EXPECT_LE(r.acceleration_mps2.norm(), 1.0 + 1e-9);
    // Acceleration comes with a lag of 0.1 s: two limits in that time at most.
    EXPECT_LE((r.acceleration_mps2 - last_acceleration).norm(), 2.0 * kStepS / 0.1 + 1e-9);
    EXPECT_LE(std::abs(r.yaw_rate_radps), 0.5 + 1e-9);
    EXPECT_LE(std::abs(r.yaw_rate_radps - last_rate), 2.0 * kStepS + 1e-9);
    last_rate = r.yaw_rate_radps;
    last_acceleration = r.acceleration_mps2;
  }
}

TEST(ReferenceMotionTest, VelocityAndAccelerationAreThoseOfThePosition) {
  ReferenceMotion motion = Motion();
  motion.StartFrom({0, 0, 0}, {0, 0, 0}, 0.0);
  Advance(motion, {{5, 0, 0}, 1.0, 1.0}, 0.7);
  const FlightReference before = motion.reference();
  motion.Advance({{5, 0, 0}, 1.0, 1.0}, kStepS);
  const FlightReference after = motion.reference();
  EXPECT_LT(((after.position_m - before.position_m) / kStepS - after.velocity_mps).norm(), 1e-9);
  EXPECT_LT(((after.velocity_mps - before.velocity_mps) / kStepS - after.acceleration_mps2).norm(),
            1e-9);
  EXPECT_NEAR((after.yaw_rad - before.yaw_rad) / kStepS, after.yaw_rate_radps, 1e-9);
}

TEST(ReferenceMotionTest, TurnsTheShortWayAndDoesNotSwingOver) {
  ReferenceMotion motion = Motion();
  motion.StartFrom({0, 0, 0}, {0, 0, 0}, 3.0);
  double beyond = 0.0;
  for (int i = 0; i < 1000; ++i) {
    motion.Advance({{0, 0, 0}, -3.0, 0.0}, kStepS);
    beyond = std::max(beyond, WrappedAngle(motion.reference().yaw_rad + 3.0));
    EXPECT_GT(std::abs(motion.reference().yaw_rad), 2.9);  // never through 0
  }
  EXPECT_NEAR(motion.reference().yaw_rad, -3.0, 1e-3);
  EXPECT_LT(beyond, 0.01);
}

TEST(ReferenceMotionTest, RestsWhereItsBrakesBringIt) {
  ReferenceMotion motion = Motion();
  motion.StartFrom({0, 0, 0}, {0.6, 0, 0}, 0.0);
  // v^2 / a, at half of the acceleration, and the lag.
  EXPECT_NEAR(motion.StoppingPlace().x(), 0.6 * 0.6 / 1.0 + 0.06, 1e-9);
  EXPECT_EQ(motion.StoppingYaw(), 0.0);
}

TEST(ReferenceMotionTest, ChangesFrame) {
  ReferenceMotion motion = Motion();
  motion.StartFrom({1, 0, 0}, {1, 0, 0}, 0.2);
  Rigid3d T_new_old(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
  T_new_old.translation() << 0, 0, 1;
  motion.ChangeFrame(T_new_old);
  EXPECT_TRUE(motion.reference().position_m.isApprox(Eigen::Vector3d(0, 1, 1)));
  EXPECT_TRUE(motion.reference().velocity_mps.isApprox(Eigen::Vector3d(0, 1, 0)));
  EXPECT_NEAR(motion.reference().yaw_rad, M_PI / 2 + 0.2, 1e-12);
}

}  // namespace
}  // namespace semantic_slam
