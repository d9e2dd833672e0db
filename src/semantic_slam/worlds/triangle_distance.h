#pragma once

#include <Eigen/Core>

namespace semantic_slam {

// Distance from p to the triangle of the corners a, b, c: to its plane if p is above or below it,
// else to the nearest edge. It may be as thin as a line or a point.
double DistanceToTriangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                          const Eigen::Vector3d& b, const Eigen::Vector3d& c);

}  // namespace semantic_slam
