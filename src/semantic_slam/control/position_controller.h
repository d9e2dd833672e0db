#pragma once

#include <Eigen/Core>

#include "semantic_slam/control/attitude_command.h"
#include "semantic_slam/control/flight_reference.h"
#include "semantic_slam/control/quadrotor_parameters.h"
#include "semantic_slam/control/thrust_direction.h"

namespace semantic_slam {

struct PositionControllerOptions {
  double proportional_gain_per_s = 2.0;  // k_p of thesis eq. (3.5): its u is a velocity
  double integral_gain_per_s2 = 0.4;     // k_i
  double derivative_gain = 0.0;          // k_d, on the velocity
  double max_speed_mps = 1.5;            // of the velocity command
  double max_integral_mps = 1.0;         // of the integral's share in it, per axis
  double velocity_gain_per_s = 5.0;      // of the inner loop, from velocity to acceleration

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("proportional_gain_per_s", self.proportional_gain_per_s, 0.0, 100.0);
    visit("integral_gain_per_s2", self.integral_gain_per_s2, 0.0, 100.0);
    visit("derivative_gain", self.derivative_gain, 0.0, 10.0);
    visit("max_speed_mps", self.max_speed_mps, 0.01, 50.0);
    visit("max_integral_mps", self.max_integral_mps, 0.0, 50.0);
    visit("velocity_gain_per_s", self.velocity_gain_per_s, 0.01, 100.0);
  }
};

// Leads the drone to a reference: the PI controller of thesis eq. (3.5) from position to velocity,
// with what the reference itself moves added, and an inner loop from velocity to acceleration,
// which becomes an attitude and a thrust. While a limit is met, the integral of an error that
// pushes farther into it stands still, so that it does not wind up. Not thread-safe.
class PositionController {
 public:
  // Throws ConfigError if an option or a parameter is out of range.
  explicit PositionController(const QuadrotorParameters& parameters = {},
                              const PositionControllerOptions& options = {},
                              const ThrustLimits& limits = {});

  // Position and velocity are in the reference's frame, z up; `step_s` is the time since the last
  // call, 0 at the first. Throws InputError, and changes nothing, if a number is not finite.
  AttitudeCommand Compute(const FlightReference& reference, const Eigen::Vector3d& position_m,
                          const Eigen::Vector3d& velocity_mps, double step_s);

  // The command for an acceleration when neither position nor velocity are known, in the level
  // frame at the drone's heading. What the integral has learnt of the mass is added.
  AttitudeCommand Steer(const Eigen::Vector3d& acceleration_mps2) const;

 private:
  void Integrate(const Eigen::Vector3d& error_m, const Eigen::Vector3d& excess_mps, double step_s);

  const QuadrotorParameters parameters_;
  const PositionControllerOptions options_;
  const ThrustLimits limits_;
  Eigen::Vector3d integral_mps_ = Eigen::Vector3d::Zero();  // k_i times the integral of the error
};

}  // namespace semantic_slam
