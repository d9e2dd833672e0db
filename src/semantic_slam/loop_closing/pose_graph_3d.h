#pragma once

#include <vector>

#include "semantic_slam/common/transform.h"

namespace semantic_slam {

// What is known of where two poses are to each other: b in the frame of a.
struct RelativePose {
  int a;  // indices into PoseGraph3d::poses
  int b;
  Rigid3d T_a_b;
  double weight = 1.0;  // square root of its information, in units of the options' sigmas
};

struct PoseGraph3d {
  std::vector<Rigid3d> poses;  // T_map_x
  std::vector<bool> fixed;     // per pose; at least one should be
  std::vector<RelativePose> edges;
};

struct PoseGraphOptions {
  double translation_sigma_m = 0.02;
  double rotation_sigma_rad = 0.01;
  int max_iterations = 20;
};

// Moves the poses that are not fixed so that all relative poses fit best in the sense of least
// squares: thesis eq. (3.8) and the second sum of (3.9), with the error log(T_a_b^-1 T_a^-1 T_b).
// Levenberg-Marquardt with sparse Cholesky (Ceres), one thread: equal input, equal result.
void OptimizePoseGraph(PoseGraph3d& graph, const PoseGraphOptions& options);

}  // namespace semantic_slam
