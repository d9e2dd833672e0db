#pragma once

#include <Eigen/Core>

#include "semantic_slam/control/quadrotor_parameters.h"

namespace semantic_slam {

// What the rotors do to the body together: collective thrust along its z axis and torque about its
// axes, in the base frame.
struct BodyWrench {
  double thrust_n = 0.0;
  Eigen::Vector3d torque_nm = Eigen::Vector3d::Zero();
};

// Where the rotors sit and what each does. They are numbered front, left, back, right; front and
// back turn clockwise seen from above, so that their drag turns the body to the left. Immutable.
class RotorMixer {
 public:
  // Throws ConfigError if a parameter is out of range.
  explicit RotorMixer(const QuadrotorParameters& parameters = {});

  BodyWrench WrenchOf(const Eigen::Vector4d& rotor_speeds_radps) const;

  // Rotor speeds that give the wrench as far as the rotors can. What they cannot is given up in
  // this order: torque about z, collective thrust (it grows or shrinks to make room), torque about
  // x and y (in proportion). Precondition: the wrench is finite.
  Eigen::Vector4d RotorSpeeds(const BodyWrench& wrench) const;

 private:
  const double thrust_constant_n_s2_;
  const double max_thrust_n_;  // of one rotor
  const double arm_length_m_;
  const double moment_constant_m_;
};

}  // namespace semantic_slam
