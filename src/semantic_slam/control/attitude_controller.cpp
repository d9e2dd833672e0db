#include "semantic_slam/control/attitude_controller.h"

#include <algorithm>

#include <Eigen/Geometry>

namespace semantic_slam {
namespace {

// The vector of a skew-symmetric matrix: Vee(Skew(v)) == v.
Eigen::Vector3d Vee(const Eigen::Matrix3d& skew) {
  return {skew(2, 1), skew(0, 2), skew(1, 0)};
}

Eigen::Vector3d PerInertia(const QuadrotorParameters& parameters, double tilt, double yaw) {
  return parameters.inertia_kg_m2().cwiseProduct(Eigen::Vector3d(tilt, tilt, yaw));
}

}  // namespace

AttitudeController::AttitudeController(const QuadrotorParameters& parameters,
                                       const AttitudeControllerOptions& options)
    : inertia_kg_m2_(Validated(parameters).inertia_kg_m2()),
      gains_nm_(
          PerInertia(parameters, Validated(options).tilt_gain_per_s2, options.yaw_gain_per_s2)),
      rate_gains_nms_(
          PerInertia(parameters, options.tilt_rate_gain_per_s, options.yaw_rate_gain_per_s)) {}

BodyWrench AttitudeController::Compute(const AttitudeCommand& command,
                                       const Eigen::Matrix3d& R_world_base,
                                       const Eigen::Vector3d& angular_velocity_radps) const {
  const Eigen::Matrix3d R_base_desired = R_world_base.transpose() * command.R_world_desired;
  // Thesis eq. (3.6).
  const Eigen::Vector3d attitude_error = 0.5 * Vee(R_base_desired.transpose() - R_base_desired);
  const Eigen::Vector3d& rates = angular_velocity_radps;
  const Eigen::Vector3d desired_rates = R_base_desired * command.angular_velocity_radps;
  const Eigen::Vector3d rate_error = rates - desired_rates;

  BodyWrench wrench;
  // Thesis eq. (3.7) with the signs that converge, and what Lee et al. (eq. 16) add: the gyroscopic
  // torque, and what it takes to keep turning at the desired rates.
  wrench.torque_nm = -gains_nm_.cwiseProduct(attitude_error) -
                     rate_gains_nms_.cwiseProduct(rate_error) +
                     rates.cross(inertia_kg_m2_.cwiseProduct(rates)) -
                     inertia_kg_m2_.cwiseProduct(rates.cross(desired_rates));
  // Lee et al., eq. 15: the force that is wanted, along the axis that there is.
  wrench.thrust_n = command.thrust_n * std::max(0.0, R_base_desired(2, 2));
  return wrench;
}

}  // namespace semantic_slam
