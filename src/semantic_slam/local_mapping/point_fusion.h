#pragma once

#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/map/map.h"
#include "semantic_slam/map/observation_noise.h"

namespace semantic_slam {

// The points that a keyframe sees, by feature.
std::vector<PointId> PointsOf(const Keyframe& keyframe);

// Whether a feature shows a point at `p_camera`: its pixel fits, and its depth, if it has one, to a
// squared normalised residual of `max_chi2_depth`. Precondition: the point is before the camera.
bool ShowsPoint(const Feature& feature, const Eigen::Vector3d& p_camera, double pyramid_scale,
                double max_chi2_depth, const CameraModel& camera, const ObservationNoise& noise);

// Looks for the points in a keyframe that does not see them yet, within `radius_px` on pyramid
// level 0 of where they should be. A feature found there either gets the point, or its own point
// turns out to be the same one, and the two are merged. Points that are gone are left out.
void FusePoints(const std::vector<PointId>& points, KeyframeId target, float radius_px,
                const CameraModel& camera, const ObservationNoise& noise, Map& map);

}  // namespace semantic_slam
