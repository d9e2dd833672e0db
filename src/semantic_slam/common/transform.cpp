#include "semantic_slam/common/transform.h"

#include <Eigen/SVD>

namespace semantic_slam {

Eigen::Matrix3d Skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Eigen::Matrix3d ExpSo3(const Eigen::Vector3d& rotation_vector) {
  const double angle = rotation_vector.norm();
  // Below this the second-order term is under the rounding of 1.0.
  if (angle < 1e-8) return Eigen::Matrix3d::Identity() + Skew(rotation_vector);
  return Eigen::AngleAxisd(angle, rotation_vector / angle).toRotationMatrix();
}

double RotationAngle(const Eigen::Matrix3d& R) { return Eigen::AngleAxisd(R).angle(); }

Rigid3d Orthonormalised(const Rigid3d& T) {
  Rigid3d result = T;
  result.linear() = Eigen::Affine3d(T.matrix()).rotation();  // the orthogonal polar factor, by SVD
  return result;
}

}  // namespace semantic_slam
