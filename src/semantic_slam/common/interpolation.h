#pragma once

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// The pose on the way from `a` (share 0) to `b` (share 1): straight on, turning at a constant rate
// about one axis.
inline Rigid3d Interpolated(const Rigid3d& a, const Rigid3d& b, double share) {
  const Eigen::Vector3d translation = (1.0 - share) * a.translation() + share * b.translation();
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
  return Eigen::Translation3d(translation) * rotation;
}

}  // namespace semantic_slam
