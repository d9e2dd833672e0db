#include "semantic_slam/control/quadrotor_model.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kStepS = 0.002;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const Eigen::Vector4d kStop = Eigen::Vector4d::Zero();

QuadrotorParameters WithoutDrag() {
  QuadrotorParameters parameters;
  parameters.rotor_drag_n_s2_per_m = 0.0;
  parameters.rotational_drag_nms = 0.0;
  return parameters;
}

QuadrotorState After(const QuadrotorModel& model, QuadrotorState state,
                     const Eigen::Vector4d& commands, double seconds,
                     const Eigen::Vector3d& push_world_n = Eigen::Vector3d::Zero()) {
  const int steps = static_cast<int>(std::lround(seconds / kStepS));
  for (int i = 0; i < steps; ++i) state = model.Step(state, commands, kStepS, push_world_n);
  return state;
}

double RotationalEnergy(const QuadrotorModel& model, const QuadrotorState& state) {
  const Eigen::Vector3d& rates = state.angular_velocity_base_radps;
  return 0.5 * rates.dot(model.parameters().inertia_kg_m2().cwiseProduct(rates));
}

TEST(QuadrotorModelTest, HoversWhereItIs) {
  const QuadrotorModel model;
  Rigid3d T_world_base(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  T_world_base.translation() << 1.0, 2.0, 3.0;
  const QuadrotorState start = model.Hovering(T_world_base);
  const QuadrotorState end = After(model, start, start.rotor_speeds_radps, 10.0);
  EXPECT_LT((end.T_world_base.matrix() - T_world_base.matrix()).norm(), 1e-9);  // rounding
  EXPECT_LT(model.Acceleration(end).norm(), 1e-9);
}

TEST(QuadrotorModelTest, FallsFreelyWithoutThrust) {
  const QuadrotorModel model(WithoutDrag());
  const QuadrotorState end = After(model, QuadrotorState(), kStop, 2.0);
  EXPECT_NEAR(end.T_world_base.translation().z(), -0.5 * 9.81 * 4.0, 1e-9);  // exact for RK4
  EXPECT_NEAR(end.velocity_world_mps.z(), -9.81 * 2.0, 1e-9);
}

TEST(QuadrotorModelTest, KeepsEnergyAndMomentumOfFreeRotation) {
  const QuadrotorModel model(WithoutDrag());
  QuadrotorState start;
  start.angular_velocity_base_radps << 5.0, -3.0, 8.0;
  const auto momentum = [&model](const QuadrotorState& state) -> Eigen::Vector3d {
    return state.T_world_base.linear() *
           model.parameters().inertia_kg_m2().cwiseProduct(state.angular_velocity_base_radps);
  };
  const QuadrotorState end = After(model, start, kStop, 5.0);
  // 10 rad/s in steps of 2 ms: (0.02)^5 per step, 2500 steps, is some 1e-5 at worst.
  EXPECT_NEAR(RotationalEnergy(model, end) / RotationalEnergy(model, start), 1.0, 1e-5);
  EXPECT_LT((momentum(end) - momentum(start)).norm() / momentum(start).norm(), 1e-5);
}

TEST(QuadrotorModelTest, DragTakesEnergyAway) {
  const QuadrotorModel model;
  QuadrotorState start = model.Hovering(Rigid3d::Identity());
  start.velocity_world_mps.x() = 1.0;
  start.angular_velocity_base_radps.z() = 1.0;
  const QuadrotorState end = After(model, start, start.rotor_speeds_radps, 1.0);
  // Four rotors at hovering speed: 0.15 N at 1 m/s on 0.816 kg.
  const double rate = 4.0 * 8.06428e-5 * model.parameters().hover_rotor_speed_radps() / 0.816;
  EXPECT_NEAR(end.velocity_world_mps.x(), std::exp(-rate), 1e-9);
  EXPECT_NEAR(end.angular_velocity_base_radps.z(), std::exp(-0.005 / 0.012), 1e-9);
}

TEST(QuadrotorModelTest, MotorsFollowWithTheirTimeConstants) {
  const QuadrotorModel model;
  QuadrotorState state;
  state.rotor_speeds_radps << 400.0, 400.0, 400.0, 400.0;
  // 12 ms in steps of 2 ms, which are up to a sixth of a time constant: RK4 is exact to 1e-5 there.
  state = After(model, state, Eigen::Vector4d(500.0, 300.0, 400.0, 500.0), 0.012);
  EXPECT_NEAR(state.rotor_speeds_radps[0], 500.0 - 100.0 * std::exp(-0.012 / 0.0125), 1e-3);
  EXPECT_NEAR(state.rotor_speeds_radps[1], 300.0 + 100.0 * std::exp(-0.012 / 0.025), 1e-3);
  EXPECT_EQ(state.rotor_speeds_radps[2], 400.0);
}

TEST(QuadrotorModelTest, CutsCommandsToWhatMotorsCan) {
  const QuadrotorModel model;
  const QuadrotorState end =
      After(model, QuadrotorState(), Eigen::Vector4d(1e6, -1e6, 838.0, 0.0), 1.0);
  EXPECT_NEAR(end.rotor_speeds_radps[0], 838.0, 1e-6);
  EXPECT_NEAR(end.rotor_speeds_radps[1], 0.0, 1e-6);
}

TEST(QuadrotorModelTest, APushAcceleratesTheMass) {
  const QuadrotorModel model;
  const QuadrotorState state = model.Hovering(Rigid3d::Identity());
  EXPECT_TRUE(model.Acceleration(state, {0.816, 0.0, -1.632}).isApprox(Eigen::Vector3d(1, 0, -2)));
}

TEST(QuadrotorModelTest, StaysFiniteAndOrthonormalWhateverTheCommands) {
  const QuadrotorModel model;
  QuadrotorState state;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> command(-1000.0, 2000.0);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector4d commands(command(random), command(random), command(random),
                                   command(random));
    state = After(model, state, commands, 0.2);
  }
  // The worst there is: a full roll torque for a minute.
  state = After(model, state, Eigen::Vector4d(0.0, 838.0, 400.0, 0.0), 60.0);
  const Eigen::Matrix3d R = state.T_world_base.linear();
  EXPECT_TRUE(state.T_world_base.matrix().allFinite());
  EXPECT_TRUE(state.angular_velocity_base_radps.allFinite());
  EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(QuadrotorModelTest, StepsOfOneAndTwoMillisecondsAgree) {
  const QuadrotorModel model;
  const Eigen::Vector4d commands(430.0, 440.0, 450.0, 435.0);
  const QuadrotorState coarse = After(model, model.Hovering(Rigid3d::Identity()), commands, 1.0);
  QuadrotorState fine = model.Hovering(Rigid3d::Identity());
  for (int i = 0; i < 1000; ++i) fine = model.Step(fine, commands, 0.001);
  // Fourth order: an error of (2 ms / 12.5 ms)^5 of the motors' lag, a 1e-4th of what they do.
  EXPECT_LT((coarse.T_world_base.matrix() - fine.T_world_base.matrix()).norm(), 1e-4);
}

TEST(QuadrotorModelTest, RefusesWhatIsNotFinite) {
  const QuadrotorModel model;
  QuadrotorState state = model.Hovering(Rigid3d::Identity());
  EXPECT_THROW(model.Step(state, Eigen::Vector4d(kNan, 0, 0, 0), kStepS), InputError);
  EXPECT_THROW(model.Step(state, kStop, kStepS, {0, kNan, 0}), InputError);
  state.velocity_world_mps.x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(model.Step(state, kStop, kStepS), InputError);
}

TEST(QuadrotorModelTest, RefusesParametersOutOfRange) {
  QuadrotorParameters parameters;
  parameters.inertia_z_kg_m2 = 0.0;
  EXPECT_THROW(QuadrotorModel{parameters}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
