#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/object_mapping/object_points.h"
#include "semantic_slam/plane_projection/hollowness.h"
#include "semantic_slam/plane_projection/top_plane.h"

namespace semantic_slam {

// What one image shows of an object, relative to the image's keyframe, in the axes of its optical
// frame [m]: where it is in the map depends on where the keyframe is today.
struct ObjectObservation {
  KeyframeId keyframe_id = kNoKeyframe;
  Eigen::Vector3d centre;                // mean of the points, thesis eq. (3.24)
  Eigen::Matrix3d covariance_m2;         // of that as an estimate of the object's own centre
  std::vector<Eigen::Vector3d> outline;  // of its top plane, or of all of it without one
  std::vector<Eigen::Vector3d> body;     // outline of all of it
  Eigen::Vector3d lowest, highest;
  SpaceBelow below;      // its top; empty if it has none
  bool complete = true;  // all of it was in view
  double quality = 0.0;  // of two observations the better one is the greater
};

// Measures an object: mean position, outline and footprint seen from above, heights, and whether
// there is room below. nullopt if the points span no area on the floor plan. Stateless.
//
//   points             in the camera's optical frame
//   R_map_camera       says which way is up
//   T_keyframe_camera  of the image, relative to its keyframe `keyframe_id`
std::optional<ObjectObservation> MeasureObject(const ObjectPoints& points,
                                               const Eigen::Matrix3d& R_map_camera,
                                               KeyframeId keyframe_id,
                                               const Rigid3d& T_keyframe_camera,
                                               const TopPlaneOptions& top_plane,
                                               const HollownessOptions& hollowness);

}  // namespace semantic_slam
