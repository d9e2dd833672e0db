#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/plane_projection/plane_ransac.h"

namespace semantic_slam {

struct TopPlaneOptions {
  double tolerance_m = 0.02;   // points nearer to the plane are on it
  double max_tilt_rad = 0.26;  // of the plane against level
  double min_share = 0.15;     // of an object's points that lie on its top
  int min_points = 30;         // that lie on it
  double upper_share = 0.4;    // of the largest plane's points: a higher one with them is the top
  int max_iterations = 200;    // of RANSAC

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("tolerance_m", self.tolerance_m, 1e-4, 1.0);
    visit("max_tilt_rad", self.max_tilt_rad, 0.0, 1.5);
    visit("min_share", self.min_share, 0.0, 1.0);
    visit("min_points", self.min_points, 3, 1000000);
    visit("upper_share", self.upper_share, 0.0, 1.0);
    visit("max_iterations", self.max_iterations, 1, 100000);
  }
};

// The top plane of an object, thesis section 3.4.3: a table's top, a chair's seat.
struct TopPlane {
  Plane plane;               // the normal points up
  double height_m = 0.0;     // mean z of the points on it
  std::vector<int> inliers;  // indices of those points, ascending
};

// The level plane of an object's points that holds most of them; or one higher up that holds nearly
// as many, as the uppermost board of a shelf does. nullopt if no level plane holds enough.
//
//   points  in any frame with z up
std::optional<TopPlane> FindTopPlane(const std::vector<Eigen::Vector3f>& points,
                                     const TopPlaneOptions& options);

}  // namespace semantic_slam
