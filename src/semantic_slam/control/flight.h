#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/control/attitude_controller.h"
#include "semantic_slam/control/position_controller.h"
#include "semantic_slam/control/quadrotor_model.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/control/waypoint_follower.h"
#include "semantic_slam/evaluation/trajectory.h"

namespace semantic_slam {

struct FlightTimeOptions {
  int steps_per_s = 600;           // of physics and control: a multiple of 30 and 200
  double max_duration_s = 1800.0;  // a flight that takes longer is given up

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("steps_per_s", self.steps_per_s, 300, 10000);
    visit("max_duration_s", self.max_duration_s, 1.0, 86400.0);
  }
};

// The options of a flight, in the groups that configuration files use.
struct FlightOptions {
  QuadrotorParameters quadrotor;
  AttitudeControllerOptions attitude_controller;
  PositionControllerOptions position_controller;
  ThrustLimits thrust;
  WaypointFollowerOptions follower;
  FlightTimeOptions time;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit_group) {
    visit_group("quadrotor", self.quadrotor);
    visit_group("attitude_controller", self.attitude_controller);
    visit_group("position_controller", self.position_controller);
    visit_group("thrust", self.thrust);
    visit_group("follower", self.follower);
    visit_group("time", self.time);
  }
};

// A flying quadrotor at one moment.
struct FlightSample {
  Stamp stamp;
  QuadrotorState state;
  // In the world frame, without gravity: an accelerometer reads R_base_world * (this + (0, 0, g)).
  Eigen::Vector3d acceleration_world_mps2 = Eigen::Vector3d::Zero();
  FlightReference reference;  // where the drone should be
  FlightStatus status;
};

// Flies through the waypoints, from hovering at the first until the last one is reached and held,
// in one loop with the controllers, who know the true state. Calls `on_sample` at `start` and
// `samples_per_s` times per second from then on, by ascending stamp. The flight does not depend on
// how often it is sampled; equal arguments give equal samples. No waypoints give no sample.
//
// Throws ConfigError if an option is out of range, `samples_per_s` does not divide the steps per
// second, or the flight takes longer than it may; InputError if a waypoint is not finite.
void FlyWaypoints(const std::vector<Waypoint>& waypoints, const FlightOptions& options,
                  int samples_per_s, Stamp start,
                  const std::function<void(const FlightSample&)>& on_sample);

// The same in a vector.
std::vector<FlightSample> FlyWaypoints(const std::vector<Waypoint>& waypoints,
                                       const FlightOptions& options, int samples_per_s,
                                       Stamp start = {});

// The poses T_world_base of a flight.
Trajectory PathOf(const std::vector<FlightSample>& samples);

}  // namespace semantic_slam
