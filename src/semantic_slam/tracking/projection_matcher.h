#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"

namespace semantic_slam {

// A point to be looked for in an image: where and how it should appear.
struct ProjectionCandidate {
  Eigen::Vector2f pixel;  // expected, undistorted
  float radius_px;        // half side of the square to search
  int min_octave;
  int max_octave;
  float angle_rad;  // of the feature it was seen as; used only with check_rotation
  const Descriptor* descriptor;  // not owned
};

struct ProjectionMatchingOptions {
  int max_distance = 100;       // of 256
  double max_ratio = 1.0;       // best over second best of the same octave; 1: no such test
  bool check_rotation = false;  // see RotationConsistency
};

// Finds each candidate among the features near the place where it should be. Features marked in
// `is_taken` (one flag per feature) are left alone. Returns, per candidate, the feature's index or
// -1; one to one, where two candidates want a feature the better fitting one gets it.
std::vector<int> MatchByProjection(const std::vector<ProjectionCandidate>& candidates,
                                   const FrameFeatures& frame, const std::vector<bool>& is_taken,
                                   const ProjectionMatchingOptions& options);

// How a map point appears from a pose. nullopt if it cannot be seen there: behind the camera, out
// of the image, nearer or farther than its scale allows, or from more than 60 degrees off the
// direction from which it was seen (ORB-SLAM, 2015, section V.D).
struct PredictedView {
  Eigen::Vector2f pixel;  // undistorted
  int octave;
  double view_cosine;  // between the mean viewing direction and this one
};
std::optional<PredictedView> PredictView(const MapPoint& point, const Rigid3d& T_camera_map,
                                         const CameraModel& camera,
                                         const std::vector<float>& scales);

}  // namespace semantic_slam
