#include "semantic_slam/control/thrust_direction.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

const Eigen::Vector3d kGravityUp(0.0, 0.0, kGravityMps2);

}  // namespace

Eigen::Vector3d LimitedAcceleration(const Eigen::Vector3d& acceleration_mps2,
                                    const QuadrotorParameters& parameters,
                                    const ThrustLimits& limits) {
  const double least = limits.min_thrust_share * kGravityMps2;
  const double most =
      std::max(limits.max_thrust_share * parameters.max_thrust_n() / parameters.mass_kg(), least);
  Eigen::Vector3d lift = acceleration_mps2 + kGravityUp;
  lift.z() = std::clamp(lift.z(), least, most);
  const double across = lift.head<2>().norm();
  const double room = std::min(lift.z() * std::tan(limits.max_tilt_deg * M_PI / 180.0),
                               std::sqrt(most * most - lift.z() * lift.z()));
  if (across > room) lift.head<2>() *= room / across;
  return lift - kGravityUp;
}

AttitudeCommand ToAttitude(const Eigen::Vector3d& acceleration_mps2, double yaw_rad,
                           double yaw_rate_radps, double mass_kg) {
  const Eigen::Vector3d lift = acceleration_mps2 + kGravityUp;
  assert(lift.z() > 0.0);
  const Eigen::Vector3d z = lift.normalized();
  const Eigen::Vector3d heading(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
  const Eigen::Vector3d y = z.cross(heading).normalized();  // z is not level, so it is no zero
  AttitudeCommand command;
  command.R_world_desired << y.cross(z), y, z;
  command.angular_velocity_radps =
      command.R_world_desired.transpose() * Eigen::Vector3d(0.0, 0.0, yaw_rate_radps);
  command.thrust_n = mass_kg * lift.norm();
  return command;
}

}  // namespace semantic_slam
