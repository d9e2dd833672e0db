#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "semantic_slam/camera/camera_twist.h"
#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/pose_covariance.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"

namespace semantic_slam {

// One image on its way through the stages of tracking.
struct FrameInWork {
  FrameInWork() = default;
  explicit FrameInWork(std::shared_ptr<const FrameFeatures> features_of_image)
      : features(std::move(features_of_image)),
        points(features->size(), kNoPoint),
        is_inlier(features->size(), false),
        moves(features->size(), false) {}

  // As if nothing had been found in it.
  void ForgetPoints() {
    points.assign(points.size(), kNoPoint);
    is_inlier.assign(is_inlier.size(), false);
  }

  std::shared_ptr<const FrameFeatures> features;
  std::vector<PointId> points;  // per feature; kNoPoint where none is matched
  std::vector<bool> is_inlier;  // per feature: its point supports the pose
  std::vector<bool> moves;      // per feature: it is on something that moves, and is left out
  Rigid3d T_map_camera = Rigid3d::Identity();
  CameraTwist twist;
  KeyframeId reference = kNoKeyframe;
  Rigid3d T_reference_camera = Rigid3d::Identity();
  Matrix6d covariance = UnknownPoseCovariance();  // of T_map_camera, as TrackedImage has it
  int inliers = 0;
};

}  // namespace semantic_slam
