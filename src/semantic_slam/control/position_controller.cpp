#include "semantic_slam/control/position_controller.h"

#include <cmath>

#include "semantic_slam/common/error.h"
#include "semantic_slam/control/limited_norm.h"

namespace semantic_slam {
namespace {

bool AllFinite(const FlightReference& reference) {
  return reference.position_m.allFinite() && reference.velocity_mps.allFinite() &&
         reference.acceleration_mps2.allFinite() && std::isfinite(reference.yaw_rad) &&
         std::isfinite(reference.yaw_rate_radps);
}

}  // namespace

PositionController::PositionController(const QuadrotorParameters& parameters,
                                       const PositionControllerOptions& options,
                                       const ThrustLimits& limits)
    : parameters_(Validated(parameters)),
      options_(Validated(options)),
      limits_(Validated(limits)) {}

AttitudeCommand PositionController::Compute(const FlightReference& reference,
                                            const Eigen::Vector3d& position_m,
                                            const Eigen::Vector3d& velocity_mps, double step_s) {
  if (!AllFinite(reference) || !position_m.allFinite() || !velocity_mps.allFinite() ||
      !std::isfinite(step_s)) {
    throw InputError(
        "position, velocity or reference of the drone has a number that is not finite");
  }
  const Eigen::Vector3d error_m = reference.position_m - position_m;
  // Thesis eq. (3.5), about the reference's own motion.
  const Eigen::Vector3d wanted_mps =
      options_.proportional_gain_per_s * error_m + integral_mps_ +
      options_.derivative_gain * (reference.velocity_mps - velocity_mps) + reference.velocity_mps;
  const Eigen::Vector3d command_mps = LimitedNorm(wanted_mps, options_.max_speed_mps);

  const double gain = options_.velocity_gain_per_s;
  const Eigen::Vector3d wanted_mps2 =
      gain * (command_mps - velocity_mps) + reference.acceleration_mps2;
  const Eigen::Vector3d command_mps2 = LimitedAcceleration(wanted_mps2, parameters_, limits_);

  Integrate(error_m, wanted_mps - command_mps + (wanted_mps2 - command_mps2) / gain, step_s);
  return ToAttitude(command_mps2, reference.yaw_rad, reference.yaw_rate_radps,
                    parameters_.mass_kg());
}

void PositionController::Integrate(const Eigen::Vector3d& error_m,
                                   const Eigen::Vector3d& excess_mps, double step_s) {
  for (int axis = 0; axis < 3; ++axis) {
    if (excess_mps[axis] * error_m[axis] > 0.0) continue;
    integral_mps_[axis] += options_.integral_gain_per_s2 * error_m[axis] * step_s;
  }
  const double limit = options_.max_integral_mps;
  integral_mps_ = integral_mps_.cwiseMax(-limit).cwiseMin(limit);
}

AttitudeCommand PositionController::Steer(const Eigen::Vector3d& acceleration_mps2) const {
  Eigen::Vector3d wanted_mps2 = acceleration_mps2;
  wanted_mps2.z() += options_.velocity_gain_per_s * integral_mps_.z();
  return ToAttitude(LimitedAcceleration(wanted_mps2, parameters_, limits_), 0.0, 0.0,
                    parameters_.mass_kg());
}

}  // namespace semantic_slam
