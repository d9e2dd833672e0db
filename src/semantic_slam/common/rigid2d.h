#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// A pose in the plane, thesis eq. (3.23): T_a_b takes coordinates in frame b to coordinates in
// frame a, as Rigid3d does in space.
using Rigid2d = Eigen::Isometry2d;

inline Rigid2d MakeRigid2d(const Eigen::Vector2d& translation_m, double yaw_rad) {
  Rigid2d T = Rigid2d::Identity();
  T.linear() = Eigen::Rotation2Dd(yaw_rad).toRotationMatrix();
  T.translation() = translation_m;
  return T;
}

// Angle [rad] of the rotation, in [-pi, pi].
inline double Yaw(const Rigid2d& T) {
  return std::atan2(T(1, 0), T(0, 0));
}

// What a pose in space looks like from above: x, y and the direction of its x axis. Precondition:
// that axis is not vertical.
inline Rigid2d Flattened(const Rigid3d& T) {
  return MakeRigid2d(T.translation().head<2>(), std::atan2(T(1, 0), T(0, 0)));
}

// The same pose in space, at height 0 and without tilt.
inline Rigid3d InSpace(const Rigid2d& T) {
  Rigid3d T_space = Rigid3d::Identity();
  T_space.linear().topLeftCorner<2, 2>() = T.linear();
  T_space.translation().head<2>() = T.translation();
  return T_space;
}

}  // namespace semantic_slam
