#pragma once

#include <vector>

#include "semantic_slam/control/quadrotor_state.h"

namespace semantic_slam {

// The speed [m/s] at which one may be `distance_m` before a stop: braking at the given rate, and at
// the end ever slower, gain * distance, so that the approach has no jerk. Any unit of length will
// do. Precondition: distance >= 0, rate and gain > 0.
double BrakingSpeed(double distance_m, double deceleration_mps2, double gain_per_s);

// How one flies past waypoints without stopping there.
struct CornerLimits {
  double radius_m = 0.3;  // of the cut corner, at most
  double max_speed_mps = 1.0;
  double max_acceleration_mps2 = 1.0;  // to turn in the corner
  double max_deceleration_mps2 = 0.5;  // to brake before it
};

// A waypoint as a part of the way.
struct Passage {
  double radius_m = 0.0;   // the way to the next one begins so near to this one; 0: at it
  double speed_mps = 0.0;  // that one may have there; 0: one stops
};

// A passage per waypoint. One stops where a waypoint wants to be held, at the last one, and where
// the way turns back; no speed is higher than one that can be braked off before the next corner.
std::vector<Passage> PlanPassages(const std::vector<Waypoint>& waypoints,
                                  const CornerLimits& limits);

}  // namespace semantic_slam
