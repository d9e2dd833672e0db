#include "semantic_slam/simulation/tour_pilot.h"

namespace semantic_slam {

TourPilot::TourPilot(const std::vector<Waypoint>& waypoints,
                     const WaypointFollowerOptions& follower,
                     const PositionControllerOptions& position_controller,
                     const ThrustLimits& thrust, const QuadrotorParameters& quadrotor)
    : follower_(follower), position_controller_(quadrotor, position_controller, thrust) {
  follower_.Replace(waypoints);
}

AttitudeCommand TourPilot::Steer(const QuadrotorState& state, double step_s) {
  const DronePlace place{state.T_world_base.translation(), state.velocity_world_mps,
                         Heading(state.T_world_base.linear())};
  if (!started_) {
    follower_.StartFrom(place);
    follower_.Advance(place, 0.0);  // from now on it holds the first waypoint, if it is there
    started_ = true;
  }
  const FlightReference reference = follower_.Advance(place, step_s);
  return position_controller_.Compute(reference, place.position_m, place.velocity_mps, step_s);
}

}  // namespace semantic_slam
