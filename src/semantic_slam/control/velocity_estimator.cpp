#include "semantic_slam/control/velocity_estimator.h"

#include <cassert>

namespace semantic_slam {
namespace {

constexpr double kStartSpeedSigmaMps = 0.5;
constexpr double kStartBiasSigmaMps2 = 1.0;

double Squared(double x) {
  return x * x;
}

}  // namespace

VelocityEstimator::VelocityEstimator(const VelocityEstimatorOptions& options)
    : options_(Validated(options)) {}

void VelocityEstimator::Restart(const Eigen::Vector3d& position_m) {
  state_.setZero();
  state_.row(0) = position_m;
  covariance_ = Eigen::Vector3d(Squared(options_.position_sigma_m), Squared(kStartSpeedSigmaMps),
                                Squared(kStartBiasSigmaMps2))
                    .asDiagonal();
}

void VelocityEstimator::Predict(const Eigen::Vector3d& acceleration_mps2, double step_s) {
  const double half = step_s * step_s / 2;
  Eigen::Matrix3d F;
  F << 1.0, step_s, half, 0.0, 1.0, step_s, 0.0, 0.0, 1.0;
  const Eigen::Vector3d G(half, step_s, 0.0);
  state_ = F * state_ + G * acceleration_mps2.transpose();
  covariance_ = F * covariance_ * F.transpose() +
                Squared(options_.acceleration_sigma_mps2) * G * G.transpose();
  covariance_(2, 2) += Squared(options_.bias_sigma_mps2) * step_s;
}

bool VelocityEstimator::Update(const Eigen::Vector3d& position_m,
                               const Eigen::Vector3d& acceleration_mps2, double step_s) {
  assert(step_s > 0.0 && position_m.allFinite() && acceleration_mps2.allFinite());
  Predict(acceleration_mps2, step_s);
  const Eigen::RowVector3d innovation = position_m.transpose() - state_.row(0);
  if (innovation.norm() > options_.max_jump_m) {
    state_.row(0) = position_m;
    return false;
  }
  const Eigen::Vector3d gain =
      covariance_.col(0) / (covariance_(0, 0) + Squared(options_.position_sigma_m));
  state_ += gain * innovation;
  // Joseph's form: it stays symmetric and positive however long the flight.
  Eigen::Matrix3d left = Eigen::Matrix3d::Identity();
  left.col(0) -= gain;
  covariance_ = left * covariance_ * left.transpose() +
                Squared(options_.position_sigma_m) * gain * gain.transpose();
  return true;
}

}  // namespace semantic_slam
