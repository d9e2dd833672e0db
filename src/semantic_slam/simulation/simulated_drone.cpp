#include "semantic_slam/simulation/simulated_drone.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/options.h"

namespace semantic_slam {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr double kHistoryS = 1.0;
constexpr double kRotationTolerance = 1e-3;  // of R^T R from identity: messages round

void CheckNumbers(const RelativeAttitudeCommand& command) {
  if (!std::isfinite(command.thrust_n) || command.thrust_n < 0.0) {
    throw InputError("thrust is " + std::to_string(command.thrust_n) +
                     " N, expected a number that is not negative");
  }
  if (!command.angular_velocity_radps.allFinite()) {
    throw InputError("angular velocity has a number that is not finite");
  }
  const Eigen::Matrix3d& R = command.R_base_desired;
  const Eigen::Matrix3d off = R.transpose() * R - Eigen::Matrix3d::Identity();
  if (!(off.norm() < kRotationTolerance && R.determinant() > 0.0)) {
    throw InputError("desired attitude is no rotation");
  }
}

}  // namespace

SimulatedDrone::SimulatedDrone(const SimulatedDroneOptions& options,
                               const QuadrotorParameters& quadrotor,
                               const AttitudeControllerOptions& attitude_controller,
                               const Rigid3d& T_world_base, Stamp start)
    : options_(Validated(options)),
      model_(quadrotor),
      mixer_(quadrotor),
      attitude_controller_(quadrotor, attitude_controller),
      start_(start),
      state_(model_.Hovering(T_world_base)),
      attitudes_{T_world_base.linear()} {}

void SimulatedDrone::Follow(const RelativeAttitudeCommand& command) {
  CheckNumbers(command);
  const Eigen::Matrix3d& R_world_base = AttitudeAt(command.stamp);
  if (command_ && command.stamp < command_->stamp) {
    throw InputError("command of " + ToString(command.stamp) + " s comes after that of " +
                     ToString(command_->stamp) + " s");
  }
  const Eigen::Matrix3d R_from_desired =
      command.level ? command.R_base_desired : R_world_base * command.R_base_desired;
  command_ = ActiveCommand{command.stamp,
                           command.level,
                           {R_from_desired, command.angular_velocity_radps, command.thrust_n}};
}

void SimulatedDrone::Follow(const AttitudeCommand& command) {
  assert(command.R_world_desired.allFinite() && std::isfinite(command.thrust_n));
  command_ = ActiveCommand{stamp(), false, command};
}

void SimulatedDrone::Step() {
  const BodyWrench wrench = attitude_controller_.Compute(CommandNow(), state_.T_world_base.linear(),
                                                         state_.angular_velocity_base_radps);
  state_ = model_.Step(state_, mixer_.RotorSpeeds(wrench), 1.0 / options_.steps_per_s);
  ++steps_;
  attitudes_.push_back(state_.T_world_base.linear());
  if (attitudes_.size() > kHistoryS * options_.steps_per_s) attitudes_.pop_front();
}

Stamp SimulatedDrone::StampAfter(std::int64_t steps) const {
  return {start_.ns + (steps * kNsPerSecond + options_.steps_per_s / 2) / options_.steps_per_s};
}

// Of the step nearest to the stamp.
const Eigen::Matrix3d& SimulatedDrone::AttitudeAt(Stamp stamp) const {
  const double steps_ago = SecondsBetween(stamp, this->stamp()) * options_.steps_per_s;
  if (!(steps_ago > -0.5 && steps_ago < static_cast<double>(attitudes_.size()) - 0.5)) {
    throw InputError("the drone does not know its attitude at " + ToString(stamp) + " s; it is " +
                     ToString(this->stamp()) + " s");
  }
  const auto back = static_cast<std::size_t>(std::llround(std::max(steps_ago, 0.0)));
  return attitudes_[attitudes_.size() - 1 - back];
}

bool SimulatedDrone::IsCommandOld() const {
  return SecondsBetween(command_->stamp, stamp()) > options_.command_timeout_s;
}

AttitudeCommand SimulatedDrone::CommandNow() const {
  const Eigen::Matrix3d& R_world_base = state_.T_world_base.linear();
  if (!is_commanded()) return LevelCommand(R_world_base, model_.parameters().hover_thrust_n());
  AttitudeCommand now = After(command_->attitude, SecondsBetween(command_->stamp, stamp()));
  if (command_->level) now.R_world_desired = LevelAttitude(R_world_base) * now.R_world_desired;
  return now;
}

}  // namespace semantic_slam
