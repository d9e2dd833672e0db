#include "semantic_slam/simulation/camera_path.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

constexpr Stamp kStart{50'000'000'000};

Tour ShortTour() {
  Tour tour;
  for (const double x_m : {1.0, 1.6}) {
    Waypoint waypoint;
    waypoint.position_m << x_m, 2.0, 1.3;
    waypoint.yaw_rad = 0.5;
    tour.waypoints.push_back(waypoint);
  }
  return tour;
}

ImuOptions PerfectImu() {
  ImuOptions imu;
  imu.noise = false;
  return imu;
}

// Ahead along z of the optical frame, level.
Rigid3d Level(double x_m, double yaw_rad) {
  return Eigen::Translation3d(x_m, 0.0, 1.0) *
         Rigid3d(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ())) * OpticalInHousing();
}

TEST(CameraPathTest, ATourIsFlownFromItsFirstWaypointToItsLast) {
  const SimulatedFlightOptions options;
  const CameraPath path = FlyTour(ShortTour(), options, kStart);
  ASSERT_GT(path.T_world_camera.size(), 30u);
  EXPECT_EQ(path.T_world_camera.front().stamp, kStart);
  for (std::size_t i = 1; i < path.T_world_camera.size(); ++i) {
    EXPECT_NEAR(SecondsBetween(path.T_world_camera[i - 1].stamp, path.T_world_camera[i].stamp),
                1.0 / 30.0, 2e-9);  // stamps are whole nanoseconds
  }
  const Rigid3d T_base_camera = HousingPose(options.mount) * OpticalInHousing();
  const auto base = [&](const StampedPose& stamped) {
    return Eigen::Vector3d((stamped.pose * T_base_camera.inverse()).translation());
  };
  EXPECT_TRUE(base(path.T_world_camera.front()).isApprox(Eigen::Vector3d(1.0, 2.0, 1.3), 1e-6));
  // Within what counts as reached.
  EXPECT_LT((base(path.T_world_camera.back()) - Eigen::Vector3d(1.6, 2.0, 1.3)).norm(), 0.1);
  EXPECT_EQ(path.readings.size(), (path.T_world_camera.size() - 1) * 20 / 3);
}

TEST(CameraPathTest, ATourMayHaveASpeedOfItsOwn) {
  Tour slow = ShortTour();
  slow.max_speed_mps = 0.2;
  EXPECT_GT(FlyTour(slow, {}, kStart).T_world_camera.size(),
            1.5 * FlyTour(ShortTour(), {}, kStart).T_world_camera.size());
}

TEST(CameraPathTest, ATourOfNothingIsNothing) {
  EXPECT_TRUE(FlyTour({}, {}, kStart).T_world_camera.empty());
  EXPECT_TRUE(FollowTrajectory({}, 30.0, 200.0, PerfectImu()).T_world_camera.empty());
}

TEST(CameraPathTest, RecordedPosesAreInterpolated) {
  const Trajectory recorded{{Stamp{0}, Level(0.0, 0.0)}, {Stamp{1'000'000'000}, Level(1.0, 0.4)}};
  const CameraPath path = FollowTrajectory(recorded, 10.0, 100.0, PerfectImu());
  ASSERT_EQ(path.T_world_camera.size(), 11u);
  EXPECT_EQ(path.T_world_camera[3].stamp.ns, 300'000'000);
  EXPECT_TRUE(path.T_world_camera[3].pose.isApprox(Level(0.3, 0.12), 1e-9));
  EXPECT_TRUE(path.T_world_camera[10].pose.isApprox(Level(1.0, 0.4), 1e-9));
  ASSERT_EQ(path.readings.size(), 100u);
  const ImuReading& middle = path.readings[50];
  // Steady, so only gravity is felt; it turns to the left, about the optical frame's -y.
  EXPECT_TRUE(middle.specific_force_mps2.isApprox(Eigen::Vector3d(0.0, -9.81, 0.0), 1e-3));
  EXPECT_TRUE(middle.angular_velocity_radps.isApprox(Eigen::Vector3d(0.0, -0.4, 0.0), 1e-6));
}

TEST(CameraPathTest, AccelerationIsFelt) {
  Trajectory recorded;  // 1 m/s^2 ahead
  for (int i = 0; i <= 200; ++i) {
    const double t_s = 0.01 * i;
    recorded.push_back({Stamp::FromSeconds(t_s), Level(0.5 * t_s * t_s, 0.0)});
  }
  const CameraPath path = FollowTrajectory(recorded, 30.0, 100.0, PerfectImu());
  EXPECT_NEAR(path.readings[100].specific_force_mps2.z(), 1.0, 1e-3);
}

TEST(CameraPathTest, RefusesRatesOutOfRange) {
  const Trajectory recorded{{Stamp{0}, Level(0.0, 0.0)}};
  EXPECT_THROW(FollowTrajectory(recorded, 0.0, 100.0, PerfectImu()), ConfigError);
  EXPECT_THROW(FollowTrajectory(recorded, 30.0, 0.0, PerfectImu()), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
