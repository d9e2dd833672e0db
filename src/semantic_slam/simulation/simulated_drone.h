#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include <Eigen/Core>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/attitude_controller.h"
#include "semantic_slam/control/quadrotor_model.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam/control/quadrotor_state.h"
#include "semantic_slam/control/rotor_mixer.h"

namespace semantic_slam {

struct SimulatedDroneOptions {
  int steps_per_s = 600;           // of physics and attitude control
  double command_timeout_s = 0.5;  // without a newer command than this the drone flies level

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("steps_per_s", self.steps_per_s, 300, 10000);
    visit("command_timeout_s", self.command_timeout_s, 0.01, 1.0);
  }
};

// A command of somebody who knows the drone's attitude only in a frame of his own, or not at all:
// it is relative to the attitude that the base had at its stamp, or, if it is `level`, to the level
// one at the heading that the base has, at every moment.
struct RelativeAttitudeCommand {
  Stamp stamp;
  bool level = false;
  Eigen::Matrix3d R_base_desired = Eigen::Matrix3d::Identity();
  Eigen::Vector3d angular_velocity_radps = Eigen::Vector3d::Zero();  // desired base frame
  double thrust_n = 0.0;
};

// A quadrotor with its autopilot: the SO(3) attitude controller runs at the rate of the physics on
// the true attitude, as autopilots do on a good estimate. Without a recent command it flies level
// with the thrust of hovering. Equal calls give equal flights. Not thread-safe.
class SimulatedDrone {
 public:
  // Hovers at rest at `T_world_base`, which must be level, at `start`. Throws ConfigError if an
  // option is out of range.
  SimulatedDrone(const SimulatedDroneOptions& options, const QuadrotorParameters& quadrotor,
                 const AttitudeControllerOptions& attitude_controller, const Rigid3d& T_world_base,
                 Stamp start);

  // From now on it follows this command. Throws InputError, and goes on as before, if a number is
  // not finite, the rotation is none, the thrust is negative, the command is older than the one
  // before, or the attitude at its stamp is not known: later than now, or more than a second ago.
  void Follow(const RelativeAttitudeCommand& command);
  // The same of somebody who knows the world frame, now. Precondition: it is finite.
  void Follow(const AttitudeCommand& command);

  // Moves on by one step.
  void Step();

  // Of the steps' grid; exact to a nanosecond at any number of steps.
  Stamp stamp() const { return StampAfter(steps_); }
  const QuadrotorState& state() const { return state_; }
  // Whether it follows somebody's command.
  bool is_commanded() const { return command_.has_value() && !IsCommandOld(); }

 private:
  struct ActiveCommand {
    Stamp stamp;
    bool level = false;
    AttitudeCommand attitude;  // at `stamp`; if it is level, in the level frame
  };

  Stamp StampAfter(std::int64_t steps) const;
  const Eigen::Matrix3d& AttitudeAt(Stamp stamp) const;
  bool IsCommandOld() const;
  AttitudeCommand CommandNow() const;

  const SimulatedDroneOptions options_;
  const QuadrotorModel model_;
  const RotorMixer mixer_;
  const AttitudeController attitude_controller_;
  const Stamp start_;
  std::int64_t steps_ = 0;
  QuadrotorState state_;
  std::deque<Eigen::Matrix3d> attitudes_;  // R_world_base of the last steps; the newest is now's
  std::optional<ActiveCommand> command_;
};

}  // namespace semantic_slam
