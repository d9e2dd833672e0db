#pragma once

#include <optional>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

struct Relocalization {
  KeyframeId keyframe;
  Rigid3d T_map_camera;
  std::vector<PointId> points;  // per feature of the frame; kNoPoint where none fits
  int inliers;
};

// Finds an image again by one keyframe, with no idea of the pose: appearance alone, then a pose from
// three points by RANSAC, refined on all inliers. nullopt with fewer than `min_inliers`. The
// random numbers have a fixed seed.
std::optional<Relocalization> RelocalizeByKeyframe(const FrameFeatures& frame, const Map& map,
                                                   KeyframeId keyframe, const CameraModel& camera,
                                                   const ObservationNoise& noise, int min_inliers);

}  // namespace semantic_slam
