#include "semantic_slam/simulation/tour_pilot.h"

#include <gtest/gtest.h>

#include "semantic_slam/control/flight.h"
#include "semantic_slam/simulation/simulated_drone.h"

namespace semantic_slam {
namespace {

constexpr int kStepsPerS = 600;
constexpr Stamp kStart{100'000'000'000};

std::vector<Waypoint> Corner() {
  return {{{0.0, 0.0, 1.0}, 0.0, 0.5}, {{1.0, 0.0, 1.2}, 0.0, 0.0}, {{1.0, 1.0, 1.0}, 1.0, 0.5}};
}

TEST(TourPilotTest, FliesAsTheOfflineFlightDoes) {
  const FlightOptions options;
  const std::vector<FlightSample> expected = FlyWaypoints(Corner(), options, 30, kStart);
  TourPilot pilot(Corner(), options.follower, options.position_controller, options.thrust,
                  options.quadrotor);
  SimulatedDrone drone({}, options.quadrotor, options.attitude_controller,
                       expected.front().state.T_world_base, kStart);
  for (const FlightSample& sample : expected) {
    ASSERT_EQ(drone.stamp(), sample.stamp);
    ASSERT_EQ(drone.state().T_world_base.matrix(), sample.state.T_world_base.matrix());
    ASSERT_EQ(pilot.IsDone(), sample.status.state == FlightState::kDone);
    for (int i = 0; i < kStepsPerS / 30; ++i) {
      drone.Follow(pilot.Steer(drone.state(), 1.0 / kStepsPerS));
      drone.Step();
    }
  }
  EXPECT_TRUE(pilot.IsDone());
}

}  // namespace
}  // namespace semantic_slam
