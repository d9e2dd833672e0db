#include "semantic_slam/evaluation/alignment.h"

#include <cassert>

#include <Eigen/SVD>

namespace semantic_slam {
namespace {

// How much orientations weigh against positions: far above rounding, far below any real path, where
// it moves the result by less than a nanometre. The floor serves a sensor that never moved.
constexpr double kRelativeOrientationWeight = 1e-9;
constexpr double kMinOrientationWeight = 1e-12;  // [m^2] per match

// The rotation R that maximises trace(R^T * correlation).
Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& correlation) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0.0) signs.z() = -1.0;
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

Rigid3d AlignTrajectories(const std::vector<MatchedPose>& matches) {
  assert(!matches.empty());
  const auto n = static_cast<double>(matches.size());
  Eigen::Vector3d reference_mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d estimate_mean = Eigen::Vector3d::Zero();
  for (const MatchedPose& match : matches) {
    reference_mean += match.T_reference_sensor.translation() / n;
    estimate_mean += match.T_estimate_sensor.translation() / n;
  }
  Eigen::Matrix3d positions = Eigen::Matrix3d::Zero();     // [m^2]
  Eigen::Matrix3d orientations = Eigen::Matrix3d::Zero();  // mean of R_reference_estimate
  for (const MatchedPose& match : matches) {
    positions += (match.T_reference_sensor.translation() - reference_mean) *
                 (match.T_estimate_sensor.translation() - estimate_mean).transpose() / n;
    orientations +=
        match.T_reference_sensor.linear() * match.T_estimate_sensor.linear().transpose() / n;
  }
  const double weight = kRelativeOrientationWeight * positions.norm() + kMinOrientationWeight;
  Rigid3d T_reference_estimate = Rigid3d::Identity();
  T_reference_estimate.linear() = NearestRotation(positions + weight * orientations);
  T_reference_estimate.translation() =
      reference_mean - T_reference_estimate.linear() * estimate_mean;
  return T_reference_estimate;
}

}  // namespace semantic_slam
