#pragma once

#include <Eigen/Core>

namespace semantic_slam {

// Where the drone should be now and how it should move, in the frame of the waypoints.
struct FlightReference {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_mps2 = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
  double yaw_rate_radps = 0.0;
};

}  // namespace semantic_slam
