#pragma once

#include <Eigen/Core>

#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam/control/rotor_mixer.h"

namespace semantic_slam {

// The gains of thesis eq. (3.7), per moment of inertia: about each axis, near the desired attitude,
// the error is that of a damped oscillator, e'' + rate_gain * e' + gain * e = 0.
struct AttitudeControllerOptions {
  double tilt_gain_per_s2 = 300.0;     // k_R about x and y
  double tilt_rate_gain_per_s = 29.0;  // k_Omega about x and y
  double yaw_gain_per_s2 = 30.0;       // k_R about z, where rotors have little torque
  double yaw_rate_gain_per_s = 9.0;    // k_Omega about z

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("tilt_gain_per_s2", self.tilt_gain_per_s2, 1.0, 1e4);
    visit("tilt_rate_gain_per_s", self.tilt_rate_gain_per_s, 0.1, 1e3);
    visit("yaw_gain_per_s2", self.yaw_gain_per_s2, 0.1, 1e4);
    visit("yaw_rate_gain_per_s", self.yaw_rate_gain_per_s, 0.1, 1e3);
  }
};

// Turns the body towards the desired attitude: the SO(3) controller of thesis eq. (3.6), (3.7),
// with the signs of Lee, Leok, McClamroch (Geometric tracking control of a quadrotor UAV on SE(3),
// CDC 2010), eq. 10, 11 and 16, whose thesis form would drive away from it. It reaches the attitude
// from everywhere but a half turn away, where the torque vanishes. Immutable.
class AttitudeController {
 public:
  // Throws ConfigError if an option or a parameter is out of range.
  explicit AttitudeController(const QuadrotorParameters& parameters = {},
                              const AttitudeControllerOptions& options = {});

  // Torque by attitude and body rates [rad/s, base frame]; the thrust is the command's as far as
  // the body's z axis points along the desired one, and never negative.
  BodyWrench Compute(const AttitudeCommand& command, const Eigen::Matrix3d& R_world_base,
                     const Eigen::Vector3d& angular_velocity_radps) const;

 private:
  const Eigen::Vector3d inertia_kg_m2_;
  const Eigen::Vector3d gains_nm_;        // k_R
  const Eigen::Vector3d rate_gains_nms_;  // k_Omega
};

}  // namespace semantic_slam
