#pragma once

#include <optional>

#include <Eigen/Core>

#include "semantic_slam/common/options.h"

namespace semantic_slam {

struct VelocityEstimatorOptions {
  double position_sigma_m = 0.005;       // of a measured position, per axis
  double acceleration_sigma_mps2 = 0.5;  // of what is expected of the acceleration, step by step
  double bias_sigma_mps2 = 0.2;          // how far what is missing in it drifts in a second
  double max_jump_m = 0.3;               // a position this far from the expected one is a jump

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("position_sigma_m", self.position_sigma_m, 1e-5, 10.0);
    visit("acceleration_sigma_mps2", self.acceleration_sigma_mps2, 1e-3, 100.0);
    visit("bias_sigma_mps2", self.bias_sigma_mps2, 0.0, 100.0);
    visit("max_jump_m", self.max_jump_m, 0.01, 100.0);
  }
};

// The velocity of a body whose position is measured with noise and whose acceleration is roughly
// known: a Kalman filter per axis over position, velocity and the part of the acceleration that is
// not known (wind, a wrong mass). A position that jumps moves the estimate's position and leaves
// its velocity as it is. Not thread-safe.
class VelocityEstimator {
 public:
  // Throws ConfigError if an option is out of range.
  explicit VelocityEstimator(const VelocityEstimatorOptions& options = {});

  // Begins anew, at rest.
  void Restart(const Eigen::Vector3d& position_m);

  // Takes in a position, `step_s` after the last one; `acceleration_mps2` is what was expected in
  // between. Returns false if the position jumped. Preconditions: Restart() was called, all is
  // finite, step_s > 0.
  bool Update(const Eigen::Vector3d& position_m, const Eigen::Vector3d& acceleration_mps2,
              double step_s);

  Eigen::Vector3d velocity_mps() const { return state_.row(1); }

 private:
  void Predict(const Eigen::Vector3d& acceleration_mps2, double step_s);

  const VelocityEstimatorOptions options_;
  // Rows: position, velocity, unknown acceleration; a column per axis.
  Eigen::Matrix3d state_ = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  // of a column; the same for all
};

}  // namespace semantic_slam
