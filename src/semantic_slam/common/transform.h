#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace semantic_slam {

// T_a_b takes coordinates in frame b to coordinates in frame a:  p_a = T_a_b * p_b.
// Neighbouring names cancel:                                     T_a_c = T_a_b * T_b_c.
// The same order as tf2:  lookupTransform("a", "b", stamp), and header.frame_id = "a",
// child_frame_id = "b". So T_map_camera is "the pose of the camera in the map".
using Rigid3d = Eigen::Isometry3d;

using Vector6d = Eigen::Matrix<double, 6, 1>;

// The correction that a SLAM node broadcasts as map -> odom (REP-105), from its own estimate of
// the robot's pose and the odometry's, both at the same stamp.
inline Rigid3d MapFromOdom(const Rigid3d& T_map_base, const Rigid3d& T_odom_base) {
  return T_map_base * T_odom_base.inverse();  // T_map_base * T_base_odom
}

// The matrix [v]x, with Skew(v) * w == v.cross(w).
Eigen::Matrix3d Skew(const Eigen::Vector3d& v);

// Rotation by |rotation_vector| radians about its direction (the exponential map of SO(3)).
Eigen::Matrix3d ExpSo3(const Eigen::Vector3d& rotation_vector);

// Angle [rad] of the rotation, in [0, pi].
double RotationAngle(const Eigen::Matrix3d& R);

// `T` with its rotation moved to the nearest orthonormal matrix. Products of many transforms drift
// off SO(3) by rounding; poses that are updated for hours need this.
Rigid3d Orthonormalised(const Rigid3d& T);

// False if any element is NaN or infinite.
inline bool IsFinite(const Rigid3d& T) { return T.matrix().allFinite(); }

}  // namespace semantic_slam
