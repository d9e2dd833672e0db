#pragma once

#include <Eigen/Core>

#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/quadrotor_parameters.h"

namespace semantic_slam {

struct ThrustLimits {
  double max_tilt_deg = 30.0;     // of the desired attitude against level
  double min_thrust_share = 0.3;  // of hovering, kept up so that the rotors can turn the body
  double max_thrust_share = 0.8;  // of all that the rotors have; the rest is for turning

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_tilt_deg", self.max_tilt_deg, 1.0, 80.0);
    visit("min_thrust_share", self.min_thrust_share, 0.0, 1.0);
    visit("max_thrust_share", self.max_thrust_share, 0.1, 1.0);
  }
};

// The acceleration (world frame) nearest to the wanted one that the rotors can give within the
// limits: height comes before the horizontal. Precondition: finite.
Eigen::Vector3d LimitedAcceleration(const Eigen::Vector3d& acceleration_mps2,
                                    const QuadrotorParameters& parameters,
                                    const ThrustLimits& limits);

// The attitude at which the thrust, together with gravity, accelerates the body so, with the x axis
// as near to the heading as that leaves (Lee et al., CDC 2010, eq. 12 and 13); it turns about the
// world's z axis. Precondition: not a free fall, acceleration.z > -kGravityMps2.
AttitudeCommand ToAttitude(const Eigen::Vector3d& acceleration_mps2, double yaw_rad,
                           double yaw_rate_radps, double mass_kg);

}  // namespace semantic_slam
