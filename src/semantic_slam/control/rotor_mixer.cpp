#include "semantic_slam/control/rotor_mixer.h"

#include <algorithm>
#include <limits>

namespace semantic_slam {
namespace {

// The sign of each rotor's drag torque about z.
const Eigen::Vector4d kTurn(1.0, -1.0, 1.0, -1.0);

// The greatest share in [0, 1] of `change` that keeps every rotor within [0, limit].
double LargestShare(const Eigen::Vector4d& thrusts, const Eigen::Vector4d& change, double limit) {
  double share = 1.0;
  for (int i = 0; i < 4; ++i) {
    const double room = change[i] > 0.0 ? limit - thrusts[i] : thrusts[i];
    const double wanted = std::abs(change[i]);
    if (wanted > room) share = std::min(share, std::max(room, 0.0) / wanted);
  }
  return share;
}

}  // namespace

RotorMixer::RotorMixer(const QuadrotorParameters& parameters)
    : thrust_constant_n_s2_(Validated(parameters).thrust_constant_n_s2),
      max_thrust_n_(parameters.max_rotor_thrust_n()),
      arm_length_m_(parameters.arm_length_m),
      moment_constant_m_(parameters.moment_constant_m) {}

BodyWrench RotorMixer::WrenchOf(const Eigen::Vector4d& rotor_speeds_radps) const {
  const Eigen::Vector4d thrusts = thrust_constant_n_s2_ * rotor_speeds_radps.array().square();
  BodyWrench wrench;
  wrench.thrust_n = thrusts.sum();
  wrench.torque_nm << arm_length_m_ * (thrusts[1] - thrusts[3]),
      arm_length_m_ * (thrusts[2] - thrusts[0]), moment_constant_m_ * kTurn.dot(thrusts);
  return wrench;
}

Eigen::Vector4d RotorMixer::RotorSpeeds(const BodyWrench& wrench) const {
  const Eigen::Vector2d lever = wrench.torque_nm.head<2>() / (2.0 * arm_length_m_);
  Eigen::Vector4d thrusts(-lever.y(), lever.x(), lever.y(), -lever.x());
  const double spread = 2.0 * lever.cwiseAbs().maxCoeff();
  if (spread > max_thrust_n_) thrusts *= max_thrust_n_ / spread;

  const double collective =
      std::clamp(wrench.thrust_n / 4.0, -thrusts.minCoeff(), max_thrust_n_ - thrusts.maxCoeff());
  thrusts.array() += collective;

  const Eigen::Vector4d yaw = kTurn * (wrench.torque_nm.z() / (4.0 * moment_constant_m_));
  thrusts += LargestShare(thrusts, yaw, max_thrust_n_) * yaw;
  return (thrusts.cwiseMax(0.0).cwiseMin(max_thrust_n_) / thrust_constant_n_s2_).cwiseSqrt();
}

}  // namespace semantic_slam
