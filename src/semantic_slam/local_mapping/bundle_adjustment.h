#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

struct BundleCamera {
  Rigid3d T_map_camera;
  bool fixed = false;
};

struct BundleObservation {
  int camera;             // index into BundleProblem::cameras
  int point;              // index into BundleProblem::points
  Eigen::Vector2d pixel;  // undistorted
  double depth_m;         // NaN if not measured
  double pyramid_scale;
};

struct BundleProblem {
  std::vector<BundleCamera> cameras;
  std::vector<Eigen::Vector3d> points;  // map frame [m]
  std::vector<BundleObservation> observations;
};

struct BundleOptions {
  ObservationNoise noise;
  int robust_iterations = 5;  // with all observations, under Huber kernels
  int final_iterations = 5;   // with those that fit after the first
};

struct BundleSummary {
  std::vector<bool> is_inlier;  // per observation: its pixel fits
  double initial_cost = 0.0;
  double final_cost = 0.0;
};

// Moves the cameras that are not fixed and all points to fit the observations best: reprojection
// and inverse-depth error as in OptimizePose(), solved by Ceres with analytic Jacobians, Schur
// complement over the points, one thread, a fixed number of iterations: equal input, equal result.
// At least one camera should be fixed; points without an observation stay.
BundleSummary AdjustBundle(BundleProblem& problem, const CameraModel& camera,
                           const BundleOptions& options);

}  // namespace semantic_slam
