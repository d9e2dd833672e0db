#pragma once

#include "semantic_slam/control/attitude_controller.h"
#include "semantic_slam/control/quadrotor_model.h"

namespace semantic_slam {

// A quadrotor with its attitude controller, which takes commands at 30 per second as from images:
// 20 steps of physics each.
class FlyingQuadrotor {
 public:
  static constexpr int kStepsPerCommand = 20;
  static constexpr double kStepS = 1.0 / 600.0;
  static constexpr double kCommandPeriodS = kStepsPerCommand * kStepS;

  explicit FlyingQuadrotor(const Rigid3d& T_world_base = Rigid3d::Identity(),
                           const QuadrotorParameters& real = {})
      : model_(real), state_(model_.Hovering(T_world_base)) {}

  const QuadrotorState& state() const { return state_; }
  Eigen::Vector3d position() const { return state_.T_world_base.translation(); }

  // Until the next command; `push_world_n` is a force from outside.
  void Fly(AttitudeCommand command, const Eigen::Vector3d& push_world_n = Eigen::Vector3d::Zero()) {
    for (int i = 0; i < kStepsPerCommand; ++i) {
      const BodyWrench wrench = controller_.Compute(command, state_.T_world_base.linear(),
                                                    state_.angular_velocity_base_radps);
      state_ = model_.Step(state_, mixer_.RotorSpeeds(wrench), kStepS, push_world_n);
      command = After(command, kStepS);
    }
  }

 private:
  const QuadrotorModel model_;
  const RotorMixer mixer_;
  const AttitudeController controller_;
  QuadrotorState state_;
};

}  // namespace semantic_slam
