#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

// A known point and where one image shows it.
struct PoseObservation {
  Eigen::Vector3d p_map;   // [m]
  Eigen::Vector2d pixel;   // undistorted
  double depth_m;          // NaN if not measured
  double pyramid_scale;    // of the level the feature was found on
};

struct PoseEstimate {
  Rigid3d T_map_camera;
  std::vector<bool> is_inlier;  // per observation: its pixel fits the pose
  int inliers = 0;
};

// The camera pose that fits the observations best, from a start near it: Levenberg-Marquardt on the
// reprojection error (thesis eq. 3.1) and the error in inverse depth, each under a Huber kernel of
// its own, so that a wrong depth at an edge does not cost the feature. Outliers are set aside after
// each of four rounds and may come back in the next (Mur-Artal and Tardos, ORB-SLAM2, T-RO 2017).
PoseEstimate OptimizePose(const std::vector<PoseObservation>& observations,
                          const Rigid3d& T_map_camera_start, const CameraModel& camera,
                          const ObservationNoise& noise);

}  // namespace semantic_slam
