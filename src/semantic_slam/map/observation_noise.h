#pragma once

namespace semantic_slam {

// What one feature measures, and how well. Pixels: 1 px on pyramid level 0 and a level's scale times
// that further up. Depth: triangulating depth sensors measure inverse depth with constant noise, so
// sigma_z = depth_sigma_at_1m * z^2 (Khoshelham and Oude Elberink, Sensors 2012, eq. 6). They measured
// 3 mm at 1 m for a Kinect; features lie at edges, and depth is exposed at another moment than
// colour, so the default is more.
struct ObservationNoise {
  double depth_sigma_at_1m_m = 0.02;

  double PixelSigma(double pyramid_scale) const { return pyramid_scale; }
  double InverseDepthSigma() const { return depth_sigma_at_1m_m; }
};

// Squared normalised residuals that 5 % of good measurements exceed (chi-square, 2 and 1 degrees of
// freedom): the line between inliers and outliers, and where the Huber kernel bends.
constexpr double kChi2Pixel = 5.991;
constexpr double kChi2Depth = 3.841;

}  // namespace semantic_slam
