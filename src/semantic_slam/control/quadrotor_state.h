#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// Where a quadrotor is and how it moves. Base frame: x forward, y left, z up (REP-103), origin at
// the centre of mass.
struct QuadrotorState {
  Rigid3d T_world_base = Rigid3d::Identity();
  Eigen::Vector3d velocity_world_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity_base_radps = Eigen::Vector3d::Zero();
  Eigen::Vector4d rotor_speeds_radps = Eigen::Vector4d::Zero();
};

// A place to fly to, thesis section 3.2.3: position and heading.
struct Waypoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
  double hold_s = 0.0;  // how long the drone stays there; 0: it passes by without stopping
};

}  // namespace semantic_slam
