#include "semantic_slam/common/pose_covariance.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Matrix6d Diagonal(double place, double rotation) {
  Vector6d diagonal;
  diagonal << Eigen::Vector3d::Constant(place), Eigen::Vector3d::Constant(rotation);
  return diagonal.asDiagonal();
}

TEST(PoseCovarianceTest, AddsWhatNoFitKnows) {
  const Matrix6d bounded = BoundedPoseCovariance(Diagonal(4e-4, 1e-4));
  EXPECT_TRUE(bounded.isApprox(Diagonal(4e-4 + 1e-6, 1e-4 + 2.5e-7), 1e-12));
  EXPECT_TRUE(BoundedPoseCovariance(Matrix6d::Zero()).isApprox(Diagonal(1e-6, 2.5e-7), 1e-12));
}

TEST(PoseCovarianceTest, WhatSaysNothingIsUnknown) {
  const Matrix6d unknown = UnknownPoseCovariance();
  EXPECT_TRUE(unknown.isApprox(Diagonal(1e6, M_PI * M_PI), 1e-12));
  Matrix6d open = Diagonal(1e-4, 1e-4);
  open(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(BoundedPoseCovariance(open), unknown);
  EXPECT_EQ(BoundedPoseCovariance(Diagonal(1e-4, -1e-4)), unknown);
  EXPECT_EQ(BoundedPoseCovariance(Diagonal(1e-4, 100.0)), unknown);
}

TEST(PoseCovarianceTest, TurnsWithTheAxes) {
  Vector6d diagonal;
  diagonal << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0;
  const Matrix6d covariance = diagonal.asDiagonal();
  const Eigen::Matrix3d quarter =
      Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  diagonal << 2.0, 1.0, 3.0, 5.0, 4.0, 6.0;
  EXPECT_TRUE(
      TurnedPoseCovariance(covariance, quarter).isApprox(Matrix6d(diagonal.asDiagonal()), 1e-12));
}

TEST(PoseCovarianceTest, AnUnsureRotationMovesWhatIsFarFromIt) {
  // 0.1 rad about z alone; what is 2 m away along x moves by 0.2 m along y.
  Matrix6d covariance = Matrix6d::Zero();
  covariance(5, 5) = 0.01;
  const Matrix6d moved =
      MovedPoseCovariance(covariance, Rigid3d::Identity(), Eigen::Vector3d(2.0, 0.0, 0.0));
  EXPECT_NEAR(moved(1, 1), 0.04, 1e-12);
  EXPECT_NEAR(moved(1, 5), 0.02, 1e-12);
  EXPECT_NEAR(moved(0, 0), 0.0, 1e-12);
  EXPECT_NEAR(moved(5, 5), 0.01, 1e-12);
}

}  // namespace
}  // namespace semantic_slam
