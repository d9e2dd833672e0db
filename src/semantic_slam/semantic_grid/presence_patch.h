#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "semantic_slam/plane_projection/convex_polygon.h"

namespace semantic_slam {

// The cells of an endless grid: cell (x, y) covers origin_m + [x, x + 1) x [y, y + 1) *
// resolution_m.
struct CellLattice {
  double resolution_m = 0.05;
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
};

// How probable it is that an object covers a cell, for the cells about it.
struct PresencePatch {
  cv::Rect cells;       // of the lattice; empty if the object covers none
  cv::Mat probability;  // cells.height x cells.width, CV_32FC1, 0..1; row 0 has the least y
};

// The share of each cell that the outline covers, averaged over where the object may be: blurred by
// the normal distribution of its position. The outline's edges are exact along x and sampled four
// times per cell along y; the blur takes x and y for independent.
//
//   sigma_m  standard deviations of the position along x and y
PresencePatch RasterisePresence(const ConvexPolygon& outline_m, const Eigen::Vector2d& sigma_m,
                                const CellLattice& lattice);

}  // namespace semantic_slam
