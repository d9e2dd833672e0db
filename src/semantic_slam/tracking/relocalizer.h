#pragma once

#include <optional>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/features/frame_features.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

// An earlier image of which it is known where some of its features are.
struct KnownView {
  struct Point {
    int feature;               // index into `features`
    Eigen::Vector3d position;  // [m], map frame
    PointId id;                // kNoPoint if it is not a point of the map
  };
  const FrameFeatures* features;  // not owned
  std::vector<Point> points;
};

// A keyframe with the map points it sees.
KnownView ViewOf(const Keyframe& keyframe, const Map& map);

struct Relocalization {
  Rigid3d T_map_camera;
  std::vector<PointId> points;  // per feature of the frame; kNoPoint where none fits
  int inliers;
};

// Finds an image again by one earlier view, with no idea of the pose: appearance alone, then a pose
// from three points by RANSAC, refined on all inliers. nullopt with fewer than `min_inliers`. The
// random numbers have a fixed seed.
std::optional<Relocalization> Relocalize(const FrameFeatures& frame, const KnownView& view,
                                         const std::vector<float>& scales,
                                         const CameraModel& camera, const ObservationNoise& noise,
                                         int min_inliers);

}  // namespace semantic_slam
