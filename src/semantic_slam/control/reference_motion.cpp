#include "semantic_slam/control/reference_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/limited_norm.h"
#include "semantic_slam/control/speed_limits.h"

namespace semantic_slam {
namespace {

constexpr double kVelocityGainPerS = 4.0;  // from velocity to acceleration
constexpr double kAccelerationLagS = 0.1;  // about that of a quadrotor's attitude
constexpr double kYawGainPerS = 2.5;       // of the approach to a heading

}  // namespace

void ReferenceMotion::StartFrom(const Eigen::Vector3d& position_m,
                                const Eigen::Vector3d& velocity_mps, double yaw_rad) {
  reference_ = FlightReference();
  reference_.position_m = position_m;
  reference_.velocity_mps = velocity_mps;
  reference_.yaw_rad = yaw_rad;
}

void ReferenceMotion::Advance(const ReferenceTarget& target, double step_s) {
  assert(step_s <= kMaxStepS * 1.001);
  AdvancePosition(target, step_s);
  AdvanceYaw(target.yaw_rad, step_s);
}

void ReferenceMotion::AdvancePosition(const ReferenceTarget& target, double step_s) {
  FlightReference& r = reference_;
  const Eigen::Vector3d way = target.position_m - r.position_m;
  const double distance = way.norm();
  Eigen::Vector3d wanted_mps = Eigen::Vector3d::Zero();
  if (distance > 0.0) wanted_mps = way * (target.max_speed_mps / distance);
  const Eigen::Vector3d wanted_mps2 =
      LimitedNorm(kVelocityGainPerS * (wanted_mps - r.velocity_mps), limits_.max_acceleration_mps2);
  r.acceleration_mps2 +=
      (wanted_mps2 - r.acceleration_mps2) * std::min(1.0, step_s / kAccelerationLagS);
  r.velocity_mps += r.acceleration_mps2 * step_s;
  r.position_m += r.velocity_mps * step_s;
}

void ReferenceMotion::AdvanceYaw(double target_yaw_rad, double step_s) {
  FlightReference& r = reference_;
  const double turn = WrappedAngle(target_yaw_rad - r.yaw_rad);
  const double rate =
      std::min(limits_.max_yaw_rate_radps,
               BrakingSpeed(std::abs(turn), kBrakingShare * limits_.max_yaw_acceleration_radps2,
                            kYawGainPerS));
  const double change = limits_.max_yaw_acceleration_radps2 * step_s;
  r.yaw_rate_radps += std::clamp(std::copysign(rate, turn) - r.yaw_rate_radps, -change, change);
  r.yaw_rad = WrappedAngle(r.yaw_rad + r.yaw_rate_radps * step_s);
}

void ReferenceMotion::ChangeFrame(const Rigid3d& T_new_old) {
  FlightReference& r = reference_;
  r.position_m = T_new_old * r.position_m;
  r.velocity_mps = T_new_old.linear() * r.velocity_mps;
  r.acceleration_mps2 = T_new_old.linear() * r.acceleration_mps2;
  r.yaw_rad = WrappedAngle(r.yaw_rad + Heading(T_new_old.linear()));
}

Eigen::Vector3d ReferenceMotion::StoppingPlace() const {
  const double speed = reference_.velocity_mps.norm();
  const double seconds = speed / (2.0 * kBrakingShare * limits_.max_acceleration_mps2);
  return reference_.position_m + reference_.velocity_mps * (seconds + kAccelerationLagS);
}

double ReferenceMotion::StoppingYaw() const {
  const double rate = reference_.yaw_rate_radps;
  return WrappedAngle(reference_.yaw_rad +
                      rate * std::abs(rate) /
                          (2.0 * kBrakingShare * limits_.max_yaw_acceleration_radps2));
}

}  // namespace semantic_slam
