#pragma once

#include <Eigen/Core>

namespace semantic_slam {

// What position control asks of attitude control.
struct AttitudeCommand {
  Eigen::Matrix3d R_world_desired = Eigen::Matrix3d::Identity();
  // Of the desired attitude, in the desired base frame.
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();
  double thrust_n = 0.0;  // collective, along the desired base's z axis
};

// The command `seconds` later, if none came since: its attitude has turned on with its velocity.
AttitudeCommand After(const AttitudeCommand& command, double seconds);

// The level attitude at the base's heading: takes coordinates there to world coordinates.
Eigen::Matrix3d LevelAttitude(const Eigen::Matrix3d& R_world_base);

// To fly level at the heading that the base has, without turning.
AttitudeCommand LevelCommand(const Eigen::Matrix3d& R_world_base, double thrust_n);

// Angle [rad] of the base's x axis about the world's z, in [-pi, pi]; 0 if it points straight up.
double Heading(const Eigen::Matrix3d& R_world_base);

// `angle` plus so many turns that it is in [-pi, pi].
double WrappedAngle(double angle_rad);

}  // namespace semantic_slam
