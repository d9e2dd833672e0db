#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// How somebody might carry a camera before the desk of TexturedRoom: it starts at rest, sweeps from
// side to side at about 0.3 m/s and 20 deg/s with the tremor of a hand, and comes back to where it
// was every 16 s. Stateless.
class HandheldPath {
 public:
  // Pose of the colour optical frame (REP-103) at `t_s` seconds after the start; exact and smooth.
  static Rigid3d T_world_camera(double t_s);

  // What an ideal accelerometer reads then [m/s^2, optical frame]: acceleration plus what holds the
  // camera up against gravity.
  static Eigen::Vector3d SpecificForce(double t_s);
};

}  // namespace semantic_slam
