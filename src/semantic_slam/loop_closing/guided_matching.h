#pragma once

#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"
#include "semantic_slam/tracking/relocalizer.h"

namespace semantic_slam {

// Looks for map points in an image whose pose is about known, and refines the pose on what it finds.
// `points` are copies, so that no lock is needed.
Relocalization MatchAround(const std::vector<MapPoint>& points, const FrameFeatures& image,
                           const Rigid3d& T_map_camera, const std::vector<float>& scales,
                           const CameraModel& camera, const ObservationNoise& noise);

}  // namespace semantic_slam
