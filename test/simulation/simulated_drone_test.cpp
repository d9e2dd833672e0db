#include "semantic_slam/simulation/simulated_drone.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr Stamp kStart{100'000'000'000};
const QuadrotorParameters kQuadrotor;

SimulatedDrone DroneAt(double height_m, const SimulatedDroneOptions& options = {}) {
  Rigid3d T_world_base = Rigid3d::Identity();
  T_world_base.translation().z() = height_m;
  T_world_base.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  return SimulatedDrone(options, kQuadrotor, {}, T_world_base, kStart);
}

void Steps(SimulatedDrone& drone, int count) {
  for (int i = 0; i < count; ++i) drone.Step();
}

// `pitch_rad` forward and down, with the thrust that keeps the height.
RelativeAttitudeCommand Pitch(double pitch_rad, Stamp stamp) {
  RelativeAttitudeCommand command;
  command.stamp = stamp;
  command.R_base_desired = ExpSo3({0.0, pitch_rad, 0.0});
  command.thrust_n = kQuadrotor.hover_thrust_n() / std::cos(pitch_rad);
  return command;
}

double Tilt(const SimulatedDrone& drone) {
  return std::acos(std::min(1.0, drone.state().T_world_base.linear()(2, 2)));
}

TEST(SimulatedDroneTest, HoversInItsPlaceWithoutCommands) {
  SimulatedDrone drone = DroneAt(1.2);
  const Rigid3d start = drone.state().T_world_base;
  Steps(drone, 6000);
  // 1e-6: ten seconds of rounding.
  EXPECT_TRUE(drone.state().T_world_base.isApprox(start, 1e-6));
  EXPECT_FALSE(drone.is_commanded());
}

TEST(SimulatedDroneTest, StampsAreExactAfterAnyNumberOfSteps) {
  SimulatedDrone drone = DroneAt(1.2);
  EXPECT_EQ(drone.stamp(), kStart);
  Steps(drone, 20);
  EXPECT_EQ(drone.stamp().ns, kStart.ns + 33'333'333);
  Steps(drone, 580);
  EXPECT_EQ(drone.stamp().ns, kStart.ns + 1'000'000'000);
}

TEST(SimulatedDroneTest, TiltsAsCommandedAndFliesForwardAtItsHeight) {
  SimulatedDrone drone = DroneAt(1.2);
  for (int i = 0; i < 10; ++i) {
    // Relative to the attitude it has: the command asks for what is missing.
    RelativeAttitudeCommand command = Pitch(0.2, drone.stamp());
    const Eigen::Matrix3d R_level_base =
        Eigen::AngleAxisd(-0.7, Eigen::Vector3d::UnitZ()) * drone.state().T_world_base.linear();
    command.R_base_desired = R_level_base.transpose() * command.R_base_desired;
    drone.Follow(command);
    Steps(drone, 60);
  }
  EXPECT_TRUE(drone.is_commanded());
  EXPECT_NEAR(Tilt(drone), 0.2, 0.01);
  const Eigen::Vector3d velocity = drone.state().velocity_world_mps;
  EXPECT_GT(velocity.head<2>().dot(Eigen::Vector2d(std::cos(0.7), std::sin(0.7))), 0.5);
  // 10 cm/s: the thrust is there before the tilt.
  EXPECT_NEAR(velocity.z(), 0.0, 0.1);
}

// A command that comes late is meant relative to the attitude that the drone had then.
TEST(SimulatedDroneTest, ResolvesACommandAtTheAttitudeOfItsStamp) {
  SimulatedDrone drone = DroneAt(1.2);
  const Stamp level = drone.stamp();
  drone.Follow(Pitch(0.3, level));
  Steps(drone, 180);
  ASSERT_NEAR(Tilt(drone), 0.3, 0.03);
  drone.Follow(Pitch(0.3, level));
  Steps(drone, 60);
  EXPECT_NEAR(Tilt(drone), 0.3, 0.03);
  drone.Follow(Pitch(0.3, drone.stamp()));
  Steps(drone, 180);
  EXPECT_NEAR(Tilt(drone), 0.6, 0.06);
}

TEST(SimulatedDroneTest, FliesLevelAgainWhenCommandsStop) {
  SimulatedDroneOptions options;
  options.command_timeout_s = 0.2;
  SimulatedDrone drone = DroneAt(1.2, options);
  drone.Follow(Pitch(0.3, drone.stamp()));
  Steps(drone, 115);
  EXPECT_TRUE(drone.is_commanded());
  Steps(drone, 300);
  EXPECT_FALSE(drone.is_commanded());
  EXPECT_NEAR(Tilt(drone), 0.0, 0.01);
}

TEST(SimulatedDroneTest, ALevelCommandCountsFromLevel) {
  SimulatedDrone drone = DroneAt(1.2);
  drone.Follow(Pitch(0.3, drone.stamp()));
  Steps(drone, 120);
  RelativeAttitudeCommand command = Pitch(0.0, drone.stamp());
  command.level = true;
  drone.Follow(command);
  Steps(drone, 270);
  EXPECT_TRUE(drone.is_commanded());
  EXPECT_NEAR(Tilt(drone), 0.0, 0.01);
  command = Pitch(-0.2, drone.stamp());  // braking
  command.level = true;
  drone.Follow(command);
  Steps(drone, 270);
  EXPECT_NEAR(Tilt(drone), 0.2, 0.02);
  EXPECT_GT(drone.state().T_world_base.linear().col(0).z(), 0.1) << "its nose is up";
}

TEST(SimulatedDroneTest, RefusesCommandsThatAreNoneAndGoesOn) {
  SimulatedDrone drone = DroneAt(1.2);
  Steps(drone, 700);
  const auto expect_refused = [&drone](const RelativeAttitudeCommand& command, const char* why) {
    ExpectOneLineWith(MessageOf<InputError>([&] { drone.Follow(command); }), {why});
  };
  const RelativeAttitudeCommand good = Pitch(0.1, drone.stamp());
  RelativeAttitudeCommand bad = good;
  bad.thrust_n = std::numeric_limits<double>::quiet_NaN();
  expect_refused(bad, "thrust is nan");
  bad.thrust_n = -1.0;
  expect_refused(bad, "thrust is -1");
  bad = good;
  bad.R_base_desired *= 1.1;
  expect_refused(bad, "no rotation");
  bad = good;
  bad.R_base_desired(0, 0) = std::numeric_limits<double>::quiet_NaN();
  expect_refused(bad, "no rotation");
  bad = good;
  bad.angular_velocity_radps.x() = std::numeric_limits<double>::infinity();
  expect_refused(bad, "angular velocity");
  expect_refused(Pitch(0.1, Stamp{drone.stamp().ns + 10'000'000}), "does not know its attitude");
  expect_refused(Pitch(0.1, kStart), "does not know its attitude");
  EXPECT_FALSE(drone.is_commanded());
  EXPECT_NO_THROW(drone.Follow(good));
  expect_refused(Pitch(0.1, Stamp{drone.stamp().ns - 10'000'000}), "comes after");
}

TEST(SimulatedDroneTest, EqualCommandsGiveEqualFlights) {
  SimulatedDrone a = DroneAt(1.2), b = DroneAt(1.2);
  for (SimulatedDrone* drone : {&a, &b}) {
    drone->Follow(Pitch(0.2, drone->stamp()));
    Steps(*drone, 100);
  }
  EXPECT_EQ(a.state().T_world_base.matrix(), b.state().T_world_base.matrix());
}

TEST(SimulatedDroneTest, RefusesOptionsOutOfRange) {
  SimulatedDroneOptions options;
  options.steps_per_s = 0;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { DroneAt(1.0, options); }), {"steps_per_s = 0"});
}

}  // namespace
}  // namespace semantic_slam
