#pragma once

#include <Eigen/Core>

namespace semantic_slam {

// `v`, shortened to `max_norm` if it is longer.
inline Eigen::Vector3d LimitedNorm(const Eigen::Vector3d& v, double max_norm) {
  const double norm = v.norm();
  return norm > max_norm ? Eigen::Vector3d(v * (max_norm / norm)) : v;
}

}  // namespace semantic_slam
