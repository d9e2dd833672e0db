#include "semantic_slam/common/pose_covariance.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace semantic_slam {
namespace {

constexpr double kLeastPlaceM = 1e-3, kLeastRotationRad = 5e-4;
constexpr double kMostPlaceM = 1e3, kMostRotationRad = M_PI;

Matrix6d Independent(double place_m, double rotation_rad) {
  Vector6d sigmas;
  sigmas << Eigen::Vector3d::Constant(place_m), Eigen::Vector3d::Constant(rotation_rad);
  return sigmas.cwiseAbs2().asDiagonal();
}

}  // namespace

Matrix6d UnknownPoseCovariance() {
  return Independent(kMostPlaceM, kMostRotationRad);
}

Matrix6d BoundedPoseCovariance(const Matrix6d& covariance) {
  if (!covariance.allFinite()) return UnknownPoseCovariance();
  const Matrix6d symmetric = 0.5 * (covariance + covariance.transpose());
  const Vector6d values = symmetric.selfadjointView<Eigen::Lower>().eigenvalues();
  const Vector6d most = UnknownPoseCovariance().diagonal();
  if (values.minCoeff() < 0.0 || (symmetric.diagonal() - most).maxCoeff() > 0.0) {
    return UnknownPoseCovariance();
  }
  return symmetric + Independent(kLeastPlaceM, kLeastRotationRad);
}

Matrix6d TurnedPoseCovariance(const Matrix6d& covariance, const Eigen::Matrix3d& R_c_a) {
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R_c_a;
  return turn * covariance * turn.transpose();
}

Matrix6d MovedPoseCovariance(const Matrix6d& covariance, const Rigid3d& T_a_b,
                             const Eigen::Vector3d& p_b_d) {
  Matrix6d move = Matrix6d::Identity();
  move.topRightCorner<3, 3>() = -Skew(T_a_b.linear() * p_b_d);
  return move * covariance * move.transpose();
}

}  // namespace semantic_slam
