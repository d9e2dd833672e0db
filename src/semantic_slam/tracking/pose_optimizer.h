#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/camera_twist.h"
#include "semantic_slam/common/pose_covariance.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/map/observation_noise.h"
#include "semantic_slam/tracking/readout_estimator.h"

namespace semantic_slam {

// A known point and where one image shows it.
struct PoseObservation {
  Eigen::Vector3d p_map;   // [m]
  Eigen::Vector2d pixel;   // undistorted, as exposed
  double depth_m;          // NaN if not measured
  double pyramid_scale;    // of the level the feature was found on
  double row_fraction = 0.0;  // of the feature: CameraModel::RowFraction()
};

// What is known of the motion while a rolling shutter reads the image. The pose is that of the middle
// row; the turn is fitted along with it, the velocity is taken as it is.
struct RollingShutter {
  double readout_s = 0.0;
  CameraTwist twist;              // as the motion so far tells
  double turn_sigma_radps = 0.1;  // of its angular velocity, per axis
};

struct PoseEstimate {
  Rigid3d T_map_camera;
  std::vector<bool> is_inlier;  // per observation: its pixel fits the pose
  int inliers = 0;
  CameraTwist twist;          // with a rolling shutter: the angular velocity that fits best
  ReadoutEvidence readout;    // with a rolling shutter, by the inliers
  // Of the pose: place [m] and rotation about fixed axes [rad], both in the map's axes, at the
  // camera. By the inliers, if their errors are independent and as large as their residuals; of the
  // points' own errors it knows nothing. Not a number if the inliers leave the pose open.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
};

// The camera pose that fits the observations best, from a start near it: Levenberg-Marquardt on the
// reprojection error (thesis eq. 3.1) and the error in inverse depth, each under a Huber kernel of
// its own, so that a wrong depth at an edge does not cost the feature. Outliers are set aside after
// each of four rounds and may come back in the next (Mur-Artal and Tardos, ORB-SLAM2, T-RO 2017).
// With a rolling shutter each row has the pose of its own time (Hedborg et al., CVPR 2012).
PoseEstimate OptimizePose(const std::vector<PoseObservation>& observations,
                          const Rigid3d& T_map_camera_start, const CameraModel& camera,
                          const ObservationNoise& noise,
                          const std::optional<RollingShutter>& shutter = std::nullopt);

}  // namespace semantic_slam
