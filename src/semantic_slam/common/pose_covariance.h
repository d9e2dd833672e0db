#pragma once

#include <Eigen/Core>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// The covariance of a pose T_a_b: place [m], then rotation about fixed axes [rad], both along the
// axes of frame a, at the origin of frame b. So does nav_msgs/Odometry want it.
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Of a pose of which nothing is known: standard deviations of 1 km and pi rad.
Matrix6d UnknownPoseCovariance();

// `covariance` with what no fit to one image knows: at least 1 mm and 0.5 mrad per axis. As unknown
// if it is not finite, not positive, or more than that.
Matrix6d BoundedPoseCovariance(const Matrix6d& covariance);

// The same along the axes of a frame c: of T_c_b, for an exact T_c_a.
Matrix6d TurnedPoseCovariance(const Matrix6d& covariance, const Eigen::Matrix3d& R_c_a);

// The same at the origin of a frame d that is fixed to b: of T_a_d, for an exact T_b_d.
Matrix6d MovedPoseCovariance(const Matrix6d& covariance, const Rigid3d& T_a_b,
                             const Eigen::Vector3d& p_b_d);

}  // namespace semantic_slam
