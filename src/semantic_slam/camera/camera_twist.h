#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// How a camera moves, in its own axes. While it moves steadily, its pose at `t_s` from now is
// T_map_camera * T_now_then(t_s).
struct CameraTwist {
  Eigen::Vector3d velocity_mps = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();

  // First order in the velocity, which is all that the few centimetres of a readout need.
  Rigid3d T_now_then(double t_s) const {
    Rigid3d T = Rigid3d::Identity();
    T.linear() = ExpSo3(t_s * angular_velocity_radps);
    T.translation() = t_s * velocity_mps;
    return T;
  }
};

}  // namespace semantic_slam
