#include "semantic_slam/control/position_controller.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "control/flying_quadrotor.h"
#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSteadyM = 0.02;  // what is asked of the steady error

FlightReference At(const Eigen::Vector3d& position_m, double yaw_rad = 0.0) {
  FlightReference reference;
  reference.position_m = position_m;
  reference.yaw_rad = yaw_rad;
  return reference;
}

// A position controller and the quadrotor that it flies.
struct Loop {
  explicit Loop(const Rigid3d& T_world_base = Rigid3d::Identity(),
                const QuadrotorParameters& real = {})
      : drone(T_world_base, real) {}

  // Returns how far beyond the reference the drone gets along `direction`, at most.
  double Fly(const FlightReference& reference, double seconds,
             const Eigen::Vector3d& push_world_n = Eigen::Vector3d::Zero(),
             const Eigen::Vector3d& direction = Eigen::Vector3d::UnitX()) {
    double beyond = 0.0;
    const int commands = static_cast<int>(std::lround(seconds * 30.0));
    for (int i = 0; i < commands; ++i) {
      drone.Fly(controller.Compute(reference, drone.position(), drone.state().velocity_world_mps,
                                   FlyingQuadrotor::kCommandPeriodS),
                push_world_n);
      beyond = std::max(beyond, direction.dot(drone.position() - reference.position_m));
    }
    return beyond;
  }
  double Error(const FlightReference& reference) const {
    return (drone.position() - reference.position_m).norm();
  }

  FlyingQuadrotor drone;
  PositionController controller;
};

TEST(PositionControllerTest, AskedForNothingItHovers) {
  PositionController controller;
  const AttitudeCommand command = controller.Compute(At({1, 2, 3}, 0.5), Eigen::Vector3d(1, 2, 3),
                                                     Eigen::Vector3d::Zero(), 0.03);
  EXPECT_NEAR(command.thrust_n, QuadrotorParameters().hover_thrust_n(), 1e-12);
  EXPECT_TRUE(command.R_world_desired.isApprox(ExpSo3({0, 0, 0.5})));
}

TEST(PositionControllerTest, IsPiByTheEquation) {
  PositionControllerOptions options;
  options.derivative_gain = 0.5;
  PositionController controller({}, options);
  const Eigen::Vector3d position(-0.1, 0, 0), velocity(0.02, 0, 0);
  const auto acceleration = [&] {
    const AttitudeCommand command = controller.Compute(At({0, 0, 0}), position, velocity, 0.5);
    return (command.R_world_desired.col(2) * command.thrust_n / 0.816).x();
  };
  // u = k_p e + k_i int e - k_d v, and 5 (u - v) is the acceleration.
  EXPECT_NEAR(acceleration(), 5.0 * (2.0 * 0.1 - 0.5 * 0.02 - 0.02), 1e-9);
  EXPECT_NEAR(acceleration(), 5.0 * (2.0 * 0.1 + 0.4 * 0.05 - 0.5 * 0.02 - 0.02), 1e-9);
}

TEST(PositionControllerTest, AStepOvershootsByLessThanATenth) {
  for (const double step : {0.2, 1.0, 5.0}) {
    for (const Eigen::Vector3d& direction :
         {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, -0.8, 0)}) {
      Loop loop;
      const FlightReference reference = At(step * direction);
      const double beyond = loop.Fly(reference, 20.0, Eigen::Vector3d::Zero(), direction);
      EXPECT_LT(beyond, 0.1 * step) << step << " m along " << direction.transpose();
      EXPECT_LT(loop.Error(reference), kSteadyM);
    }
  }
}

TEST(PositionControllerTest, TheIntegralTakesAConstantPushAway) {
  Loop loop;
  const Eigen::Vector3d push(0.5, -0.3, 0.4);  // N; gravity is 8
  loop.Fly(At({0, 0, 0}), 2.0, push);
  EXPECT_GT(loop.Error(At({0, 0, 0})), kSteadyM);  // there is something to take away
  loop.Fly(At({0, 0, 0}), 20.0, push);
  EXPECT_LT(loop.Error(At({0, 0, 0})), kSteadyM);
  // A step then is as good as without.
  EXPECT_LT(loop.Fly(At({1, 0, 0}), 20.0, push), 0.1);
  EXPECT_LT(loop.Error(At({1, 0, 0})), kSteadyM);
}

TEST(PositionControllerTest, TheIntegralLearnsTheMass) {
  for (const double payload_kg : {0.0, 0.25}) {
    QuadrotorParameters real;
    real.payload_mass_kg = payload_kg;  // the controller takes it for 0.1 kg
    Loop loop(Rigid3d::Identity(), real);
    loop.Fly(At({0, 0, 0}), 30.0);
    EXPECT_LT(loop.Error(At({0, 0, 0})), kSteadyM) << payload_kg;
    const AttitudeCommand blind = loop.controller.Steer(Eigen::Vector3d::Zero());
    EXPECT_NEAR(blind.thrust_n, real.hover_thrust_n(), 0.05) << payload_kg;
  }
}

TEST(PositionControllerTest, DoesNotWindUpWhileItIsHeldBack) {
  // Far away for a long time: the velocity command is at its limit all the way.
  Loop loop;
  const FlightReference far = At({40, 0, 0});
  EXPECT_LT(loop.Fly(far, 60.0), 0.1);  // as after a step of a metre
  EXPECT_LT(loop.Error(far), kSteadyM);
  // And against a push that is stronger than the tilt's limit, then gone: 8 N against 4.6.
  Loop held;
  held.Fly(At({0, 0, 0}), 5.0, {-8.0, 0, 0});
  held.Fly(At({0, 0, 0}), 1.0);
  EXPECT_LT(held.Fly(At({0, 0, 0}), 120.0), 0.5);
  EXPECT_LT(held.Error(At({0, 0, 0})), kSteadyM);
}

TEST(PositionControllerTest, RecoversFromATiltOfSixtyDegrees) {
  for (const double direction : {0.0, 1.0, 2.5, 4.0}) {
    const Eigen::Vector3d axis(std::cos(direction), std::sin(direction), 0.0);
    Loop loop(Rigid3d(ExpSo3(M_PI / 3 * axis)));
    loop.Fly(At({0, 0, 0}), 15.0);
    EXPECT_LT(loop.Error(At({0, 0, 0})), kSteadyM);
    EXPECT_LT(RotationAngle(loop.drone.state().T_world_base.linear()), 0.02);
  }
}

TEST(PositionControllerTest, RecoversFromAHeadingThatIsFarOff) {
  const double turn = 2.0 * M_PI / 3;
  Loop loop(Rigid3d(ExpSo3({0, 0, turn}) * ExpSo3({0.5, 0, 0})));
  loop.Fly(At({0, 0, 0}), 15.0);
  EXPECT_LT(loop.Error(At({0, 0, 0})), kSteadyM);
  EXPECT_LT(RotationAngle(loop.drone.state().T_world_base.linear()), 0.02);
}

TEST(PositionControllerTest, HoldsAHeadingAtTheWrap) {
  for (const double yaw : {M_PI, -M_PI, 3.1, -3.1}) {
    Loop loop(Rigid3d(ExpSo3({0, 0, 3.0})));
    loop.Fly(At({0.5, 0, 0}, yaw), 10.0);
    EXPECT_LT(std::abs(WrappedAngle(Heading(loop.drone.state().T_world_base.linear()) - yaw)),
              0.02);
  }
}

TEST(PositionControllerTest, SteersBlindlyAlongTheLevelFrame) {
  const AttitudeCommand command = PositionController().Steer({1.0, 0.0, 0.0});
  EXPECT_NEAR((command.R_world_desired.col(2) * command.thrust_n / 0.816).x(), 1.0, 1e-12);
  EXPECT_NEAR(Heading(command.R_world_desired), 0.0, 1e-12);
}

TEST(PositionControllerTest, RefusesWhatIsNotFiniteAndGoesOn) {
  PositionController controller;
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), bad(kNan, 0, 0);
  EXPECT_THROW(controller.Compute(At(bad), zero, zero, 0.03), InputError);
  EXPECT_THROW(controller.Compute(At(zero), bad, zero, 0.03), InputError);
  EXPECT_THROW(controller.Compute(At(zero), zero, bad, 0.03), InputError);
  EXPECT_THROW(controller.Compute(At(zero, kNan), zero, zero, 0.03), InputError);
  EXPECT_THROW(controller.Compute(At(zero), zero, zero, kNan), InputError);
  EXPECT_NEAR(controller.Compute(At(zero), zero, zero, 0.03).thrust_n,
              QuadrotorParameters().hover_thrust_n(), 1e-12);
}

TEST(PositionControllerTest, RefusesOptionsOutOfRange) {
  PositionControllerOptions options;
  options.max_speed_mps = 0.0;
  EXPECT_THROW(PositionController({}, options), ConfigError);
  ThrustLimits limits;
  limits.max_tilt_deg = 90.0;
  EXPECT_THROW(PositionController({}, {}, limits), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
