#include "semantic_slam/simulation/simulated_flight.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr Stamp kStart{100'000'000'000};

Rigid3d StartPose() {
  Rigid3d T_world_base = Rigid3d::Identity();
  T_world_base.translation() << 1.0, 2.0, 1.2;
  return T_world_base;
}

SimulatedFlightOptions WithoutNoise() {
  SimulatedFlightOptions options;
  options.imu.noise = false;
  return options;
}

TEST(SimulatedFlightTest, ImagesAreDueAtTheirRateAndReadingsComeBetween) {
  SimulatedFlight flight(WithoutNoise(), StartPose(), kStart);
  EXPECT_EQ(flight.stamp(), kStart);
  std::vector<ImuReading> readings;
  for (int k = 1; k <= 30; ++k) {
    for (const ImuReading& reading : flight.FlyToNextImage()) readings.push_back(reading);
    EXPECT_EQ(flight.stamp().ns, kStart.ns + std::llround(k * 1e9 / 30));
    EXPECT_LE(readings.back().stamp, flight.stamp());
  }
  ASSERT_EQ(readings.size(), 200u);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_EQ(readings[i].stamp.ns, kStart.ns + static_cast<std::int64_t>(i + 1) * 5'000'000);
  }
}

TEST(SimulatedFlightTest, TheImuHasTheCamerasAxes) {
  SimulatedFlight flight(WithoutNoise(), StartPose(), kStart);
  const ImuReading reading = flight.FlyToNextImage().back();
  EXPECT_TRUE(reading.specific_force_mps2.isApprox(Eigen::Vector3d(0, -kGravityMps2, 0), 1e-9));
}

TEST(SimulatedFlightTest, TheCameraLooksAheadAndDown) {
  SimulatedFlightOptions options = WithoutNoise();
  options.mount.camera_pitch_deg = 30.0;
  const SimulatedFlight flight(options, StartPose(), kStart);
  const Rigid3d T_world_camera = flight.T_world_camera();
  EXPECT_TRUE(T_world_camera.translation().isApprox(Eigen::Vector3d(1.1, 2.0, 1.2), 1e-12));
  const Eigen::Vector3d view = T_world_camera.linear().col(2);
  EXPECT_TRUE(view.isApprox(Eigen::Vector3d(std::cos(M_PI / 6), 0, -std::sin(M_PI / 6)), 1e-12));
  EXPECT_NEAR(T_world_camera.linear()(1, 0), -1.0, 1e-12)
      << "the image's right is the base's right";
}

TEST(SimulatedFlightTest, FliesATourToItsEnd) {
  SimulatedFlight flight(WithoutNoise(), StartPose(), kStart);
  const Waypoint goal{{2.0, 2.0, 1.2}, 0.0, 0.5};
  flight.FlyTour({goal});
  for (int k = 0; k < 300 && !flight.IsTourDone(); ++k) flight.FlyToNextImage();
  EXPECT_TRUE(flight.IsTourDone());
  EXPECT_LT((flight.state().T_world_base.translation() - goal.position_m).norm(), 0.05);
}

TEST(SimulatedFlightTest, FollowsCommands) {
  SimulatedFlight flight(WithoutNoise(), StartPose(), kStart);
  RelativeAttitudeCommand command;
  command.stamp = flight.stamp();
  command.R_base_desired = ExpSo3({0.0, 0.1, 0.0});
  command.thrust_n = QuadrotorParameters().hover_thrust_n();
  flight.Follow(command);
  for (int k = 0; k < 10; ++k) flight.FlyToNextImage();
  EXPECT_GT(flight.state().velocity_world_mps.x(), 0.1);
  EXPECT_FALSE(flight.IsTourDone());
}

TEST(SimulatedFlightTest, RefusesARateThatDoesNotDivideTheSteps) {
  SimulatedFlightOptions options;
  options.mount.image_rate_hz = 7;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { SimulatedFlight(options, StartPose(), kStart); }),
                    {"mount/image_rate_hz = 7", "steps_per_s = 600"});
}

}  // namespace
}  // namespace semantic_slam
