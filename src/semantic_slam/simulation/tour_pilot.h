#pragma once

#include <vector>

#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/position_controller.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/control/waypoint_follower.h"

namespace semantic_slam {

// Flies a quadrotor through the waypoints of a tour by its true state, as FlyWaypoints() does, for
// who looks at what happens on the way. Not thread-safe.
class TourPilot {
 public:
  // Throws ConfigError if an option is out of range, InputError if a waypoint is not finite.
  TourPilot(const std::vector<Waypoint>& waypoints, const WaypointFollowerOptions& follower,
            const PositionControllerOptions& position_controller, const ThrustLimits& thrust,
            const QuadrotorParameters& quadrotor);

  // What the quadrotor shall do in the next `step_s`. Precondition: the state is finite.
  AttitudeCommand Steer(const QuadrotorState& state, double step_s);

  // At the last waypoint, and held there for as long as that wants.
  bool IsDone() const { return follower_.status().state == FlightState::kDone; }

 private:
  WaypointFollower follower_;
  PositionController position_controller_;
  bool started_ = false;
};

}  // namespace semantic_slam
