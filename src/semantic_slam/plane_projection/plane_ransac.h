#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace semantic_slam {

// n . p + D = 0, thesis eq. (3.26).
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // n, of unit length
  double offset_m = 0.0;                              // D

  // Positive on the side to which the normal points.
  double SignedDistance(const Eigen::Vector3d& p) const { return normal.dot(p) + offset_m; }
};

struct PlaneFit {
  Plane plane;
  std::vector<int> inliers;  // indices of the points on it, ascending
};

// What a plane has to be like.
struct PlaneConstraint {
  double tolerance_m = 0.02;  // points nearer to the plane are on it
  int max_iterations = 200;
  // With an axis (of unit length): the normal is within `max_tilt_rad` of it, and points its way.
  std::optional<Eigen::Vector3d> axis;
  double max_tilt_rad = 0.26;
};

// The plane with most points on it (Fischler and Bolles, RANSAC, 1981, as PCL has it), refined by
// least squares on them. nullopt if there is none with at least `min_inliers`. The same points give
// the same plane: the random numbers have a fixed seed.
std::optional<PlaneFit> FitPlane(const std::vector<Eigen::Vector3f>& points, int min_inliers,
                                 const PlaneConstraint& constraint);

}  // namespace semantic_slam
