#pragma once

#include <Eigen/Core>

#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/control/rotor_mixer.h"

namespace semantic_slam {

// How a quadrotor moves: a rigid body under gravity, four rotors that follow their commands with
// the lag of motors, and their drag (Furrer et al., RotorS, 2016; Mahony, Kumar, Corke, Multirotor
// aerial vehicles, 2012). There is no floor. Immutable.
class QuadrotorModel {
 public:
  // Throws ConfigError if a parameter is out of range.
  explicit QuadrotorModel(const QuadrotorParameters& parameters = {});

  const QuadrotorParameters& parameters() const { return parameters_; }

  // At rest at that pose, with the rotors at the speed of hovering.
  QuadrotorState Hovering(const Rigid3d& T_world_base) const;

  // The state `step_s` later, by one Runge-Kutta step of fourth order; steps of 1 or 2 ms suit. The
  // commands are cut to what the motors can. `push_world_n` is a force from outside, wind say.
  // Throws InputError if state, commands or push are not finite. Precondition: step_s > 0.
  QuadrotorState Step(const QuadrotorState& state, const Eigen::Vector4d& rotor_commands_radps,
                      double step_s,
                      const Eigen::Vector3d& push_world_n = Eigen::Vector3d::Zero()) const;

  // [m/s^2] in the world frame. An accelerometer at the centre of mass reads this without gravity:
  // R_base_world * (acceleration + (0, 0, kGravityMps2)).
  Eigen::Vector3d Acceleration(const QuadrotorState& state,
                               const Eigen::Vector3d& push_world_n = Eigen::Vector3d::Zero()) const;

 private:
  struct Derivative;
  Derivative DerivativeOf(const QuadrotorState& state, const Eigen::Vector4d& rotor_commands_radps,
                          const Eigen::Vector3d& push_world_n) const;
  Eigen::Vector3d AngularAcceleration(const QuadrotorState& state) const;

  const QuadrotorParameters parameters_;
  const RotorMixer mixer_;
};

}  // namespace semantic_slam
