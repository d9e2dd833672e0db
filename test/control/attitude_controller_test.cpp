#include "semantic_slam/control/attitude_controller.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/quadrotor_model.h"

namespace semantic_slam {
namespace {

constexpr double kStepS = 0.002;

AttitudeCommand Desired(const Eigen::Matrix3d& R_world_desired) {
  AttitudeCommand command;
  command.R_world_desired = R_world_desired;
  command.thrust_n = QuadrotorParameters().hover_thrust_n();
  return command;
}

Eigen::Matrix3d RandomRotation(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

// The angle that is left after `seconds` of the whole quadrotor, motors and limits included.
double AngleAfter(const AttitudeCommand& command, QuadrotorState state, double seconds) {
  const QuadrotorModel model;
  const RotorMixer mixer;
  const AttitudeController controller;
  const int steps = static_cast<int>(std::lround(seconds / kStepS));
  for (int i = 0; i < steps; ++i) {
    const BodyWrench wrench = controller.Compute(
        After(command, i * kStepS), state.T_world_base.linear(), state.angular_velocity_base_radps);
    state = model.Step(state, mixer.RotorSpeeds(wrench), kStepS);
  }
  return RotationAngle(state.T_world_base.linear().transpose() *
                       After(command, seconds).R_world_desired);
}

TEST(AttitudeControllerTest, WantsNoTorqueWhereItShouldBe) {
  std::mt19937 random(1);
  const Eigen::Matrix3d R = RandomRotation(random);
  const BodyWrench wrench = AttitudeController().Compute(Desired(R), R, Eigen::Vector3d::Zero());
  EXPECT_LT(wrench.torque_nm.norm(), 1e-12);
  EXPECT_NEAR(wrench.thrust_n, QuadrotorParameters().hover_thrust_n(), 1e-12);
}

TEST(AttitudeControllerTest, TurnsTowardsTheDesiredAttitude) {
  const Eigen::Vector3d turn(0.01, -0.02, 0.03);
  const BodyWrench wrench = AttitudeController().Compute(
      Desired(ExpSo3(turn)), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
  // Small angles: the gains per inertia times the angle; what is left out is of the second order.
  EXPECT_NEAR(wrench.torque_nm.x(), 0.007 * 300.0 * 0.01, 0.007 * 300.0 * 1e-3);
  EXPECT_NEAR(wrench.torque_nm.y(), -0.007 * 300.0 * 0.02, 0.007 * 300.0 * 1e-3);
  EXPECT_NEAR(wrench.torque_nm.z(), 0.012 * 30.0 * 0.03, 0.012 * 30.0 * 1e-3);
}

TEST(AttitudeControllerTest, BrakesRatesAndMakesUpForTheGyroscopicTorque) {
  const Eigen::Vector3d rates(1.0, 0.0, 2.0);
  const BodyWrench wrench = AttitudeController().Compute(Desired(Eigen::Matrix3d::Identity()),
                                                         Eigen::Matrix3d::Identity(), rates);
  const Eigen::Vector3d momentum(0.007 * 1.0, 0.0, 0.012 * 2.0);
  const Eigen::Vector3d braking(-0.007 * 29.0 * 1.0, 0.0, -0.012 * 9.0 * 2.0);
  EXPECT_TRUE(wrench.torque_nm.isApprox(braking + rates.cross(momentum)));
}

TEST(AttitudeControllerTest, ThrustIsWhatPointsAlongTheDesiredAxis) {
  const AttitudeController controller;
  const Eigen::Vector3d still = Eigen::Vector3d::Zero();
  const AttitudeCommand up = Desired(Eigen::Matrix3d::Identity());
  EXPECT_NEAR(controller.Compute(up, ExpSo3({M_PI / 3, 0, 0}), still).thrust_n, up.thrust_n / 2,
              1e-12);
  EXPECT_EQ(controller.Compute(up, ExpSo3({2.0, 0, 0}), still).thrust_n, 0.0);
}

TEST(AttitudeControllerTest, ConvergesFromRandomAttitudesAndRates) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal(0.0, 2.0);
  for (int i = 0; i < 100; ++i) {
    QuadrotorState start = QuadrotorModel().Hovering(Rigid3d(RandomRotation(random)));
    start.angular_velocity_base_radps << normal(random), normal(random), normal(random);
    // Yaw, the slowest, takes a second per factor of 1/e^3; near a half turn the torque is small.
    EXPECT_LT(AngleAfter(Desired(RandomRotation(random)), start, 5.0), 1e-3) << "attitude " << i;
  }
}

TEST(AttitudeControllerTest, FollowsATurningAttitude) {
  AttitudeCommand command = Desired(Eigen::Matrix3d::Identity());
  command.angular_velocity_radps.z() = 0.7;
  const QuadrotorState start = QuadrotorModel().Hovering(Rigid3d::Identity());
  // The rotational drag, which the controller does not know, is 0.3 rad/s^2 at that rate: 0.01 rad.
  EXPECT_LT(AngleAfter(command, start, 6.0), 0.015);
}

TEST(AttitudeControllerTest, TiltSettlesInHalfASecond) {
  const QuadrotorState start = QuadrotorModel().Hovering(Rigid3d(ExpSo3({M_PI / 3, 0, 0})));
  EXPECT_LT(AngleAfter(Desired(Eigen::Matrix3d::Identity()), start, 0.5), 0.05);
}

TEST(AttitudeControllerTest, RefusesGainsOutOfRange) {
  AttitudeControllerOptions options;
  options.yaw_gain_per_s2 = -1.0;
  EXPECT_THROW(AttitudeController({}, options), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
