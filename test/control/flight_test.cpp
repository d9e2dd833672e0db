#include "semantic_slam/control/flight.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

Waypoint At(double x, double y, double z, double yaw_rad = 0.0, double hold_s = 0.0) {
  Waypoint waypoint;
  waypoint.position_m << x, y, z;
  waypoint.yaw_rad = yaw_rad;
  waypoint.hold_s = hold_s;
  return waypoint;
}

std::vector<Waypoint> Square() {
  return {At(1, 1, 1, 0.5, 1.0), At(4, 1, 1.2, 0.5), At(4, 3, 1.2, 2.0), At(1, 3, 1, 3.1),
          At(1, 1, 1, -2.0, 1.0)};
}

TEST(FlightTest, StartsAtRestAtTheFirstWaypoint) {
  const FlightSample first = FlyWaypoints(Square(), {}, 30).front();
  EXPECT_EQ(first.stamp, Stamp{});
  EXPECT_EQ(first.state.T_world_base.translation(), Eigen::Vector3d(1, 1, 1));
  EXPECT_NEAR(Heading(first.state.T_world_base.linear()), 0.5, 1e-12);
  EXPECT_EQ(first.state.velocity_world_mps, Eigen::Vector3d::Zero());
  EXPECT_LT(first.acceleration_world_mps2.norm(), 1e-12);
}

TEST(FlightTest, SamplesAtExactStamps) {
  const Stamp start{1'000'000'000'000'000'123};
  const std::vector<FlightSample> samples = FlyWaypoints({At(0, 0, 1, 0.0, 1.0)}, {}, 30, start);
  ASSERT_GE(samples.size(), 30u);
  EXPECT_EQ(samples[0].stamp, start);
  EXPECT_EQ(samples[1].stamp.ns - start.ns, 33'333'333);
  EXPECT_EQ(samples[2].stamp.ns - start.ns, 66'666'667);
  EXPECT_EQ(samples[30].stamp.ns - start.ns, 1'000'000'000);
}

TEST(FlightTest, VisitsTheWaypointsAndEndsAtTheLast) {
  const std::vector<FlightSample> samples = FlyWaypoints(Square(), {}, 30);
  for (const Waypoint& waypoint : Square()) {
    double nearest = 1e9;
    for (const FlightSample& sample : samples) {
      nearest =
          std::min(nearest, (sample.state.T_world_base.translation() - waypoint.position_m).norm());
    }
    EXPECT_LT(nearest, 0.2);
  }
  const FlightSample& last = samples.back();
  EXPECT_EQ(last.status.state, FlightState::kDone);
  EXPECT_LT((last.state.T_world_base.translation() - Eigen::Vector3d(1, 1, 1)).norm(), 0.03);
}

TEST(FlightTest, TheDroneIsWhereItsReferenceIs) {
  for (const FlightSample& sample : FlyWaypoints(Square(), {}, 30)) {
    EXPECT_LT((sample.state.T_world_base.translation() - sample.reference.position_m).norm(), 0.04);
  }
}

TEST(FlightTest, SettlesWithoutOvershoot) {
  double beyond = 0.0;
  const std::vector<FlightSample> samples =
      FlyWaypoints({At(0, 0, 1), At(2, 0, 1, 0.0, 5.0)}, {}, 30);
  for (const FlightSample& sample : samples) {
    beyond = std::max(beyond, sample.state.T_world_base.translation().x() - 2.0);
  }
  EXPECT_LT(beyond, 0.02);  // a hundredth of the way
  EXPECT_LT((samples.back().state.T_world_base.translation() - Eigen::Vector3d(2, 0, 1)).norm(),
            0.02);
}

TEST(FlightTest, AccelerationAndRatesAreThoseOfThePath) {
  const std::vector<FlightSample> samples = FlyWaypoints(Square(), {}, 600);
  for (std::size_t i = 1; i + 1 < samples.size(); i += 37) {
    const QuadrotorState &before = samples[i - 1].state, &after = samples[i + 1].state;
    const double gap_s = SecondsBetween(samples[i - 1].stamp, samples[i + 1].stamp);
    const Eigen::Vector3d acceleration =
        (after.velocity_world_mps - before.velocity_world_mps) / gap_s;
    // Differences over 3.3 ms, in which jerk and angular acceleration change a little.
    EXPECT_LT((acceleration - samples[i].acceleration_world_mps2).norm(), 0.02);
    const Eigen::AngleAxisd turn(before.T_world_base.linear().transpose() *
                                 after.T_world_base.linear());
    EXPECT_LT(
        (turn.axis() * turn.angle() / gap_s - samples[i].state.angular_velocity_base_radps).norm(),
        0.02);
  }
}

TEST(FlightTest, IsTheSameHoweverOftenItIsSampled) {
  const std::vector<FlightSample> few = FlyWaypoints(Square(), {}, 30);
  const std::vector<FlightSample> many = FlyWaypoints(Square(), {}, 600);
  for (std::size_t i = 0; i < few.size() && 20 * i < many.size(); ++i) {
    EXPECT_EQ(few[i].stamp, many[20 * i].stamp);
    EXPECT_EQ(few[i].state.T_world_base.matrix(), many[20 * i].state.T_world_base.matrix());
  }
}

TEST(FlightTest, HandlesNoneOneAndIdenticalWaypoints) {
  EXPECT_TRUE(FlyWaypoints({}, {}, 30).empty());
  EXPECT_GE(FlyWaypoints({At(1, 2, 3)}, {}, 30).size(), 1u);
  EXPECT_EQ(FlyWaypoints({At(0, 0, 1), At(0, 0, 1), At(0, 0, 1)}, {}, 30).back().status.index, 2u);
}

TEST(FlightTest, ThePathHasAPosePerSample) {
  const std::vector<FlightSample> samples = FlyWaypoints({At(0, 0, 1, 0, 0.5)}, {}, 30);
  const Trajectory path = PathOf(samples);
  ASSERT_EQ(path.size(), samples.size());
  EXPECT_EQ(path.back().stamp, samples.back().stamp);
  EXPECT_EQ(path.back().pose.matrix(), samples.back().state.T_world_base.matrix());
}

TEST(FlightTest, RefusesWhatItCannotFly) {
  EXPECT_THROW(FlyWaypoints(Square(), {}, 0), ConfigError);
  EXPECT_THROW(FlyWaypoints(Square(), {}, 7), ConfigError);
  FlightOptions options;
  options.time.max_duration_s = 2.0;
  EXPECT_THROW(FlyWaypoints(Square(), options, 30), ConfigError);
  options = {};
  options.follower.max_speed_mps = -1.0;
  EXPECT_THROW(FlyWaypoints(Square(), options, 30), ConfigError);
  EXPECT_THROW(FlyWaypoints({At(std::numeric_limits<double>::quiet_NaN(), 0, 0)}, {}, 30),
               InputError);
}

}  // namespace
}  // namespace semantic_slam
