#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/control/quadrotor_state.h"

namespace semantic_slam {

// A flight through a world: where it starts, and where it goes to.
struct Tour {
  std::vector<Waypoint> waypoints;      // in the world frame; the drone starts at the first
  std::optional<double> max_speed_mps;  // if this tour wants another than the follower's option
};

// Reads a tour:
//
//   max_speed_mps: 0.6                       # may be left out
//   waypoints:
//     - {position_m: [1, 2, 1.4], yaw_deg: 90, hold_s: 2}   # hold_s may be left out
//
// Throws ConfigError naming file, line and key if it is none. A list without waypoints is one.
Tour LoadTour(const std::string& path);

// The waypoints as seen from the first: that is the origin, level and heading along x, where the
// map of a drone begins that starts there. Empty for none.
std::vector<Waypoint> RelativeToFirst(const std::vector<Waypoint>& waypoints);

}  // namespace semantic_slam
