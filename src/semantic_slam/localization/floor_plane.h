#pragma once

#include <optional>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"

namespace semantic_slam {

// The upward normal (unit, optical frame) of the largest level surface that one depth image shows: a
// floor, or a table top, which will do as well. nullopt if no plane within 50 degrees of
// `expected_up_camera` lies at least 0.2 m below the camera and holds a tenth of the depth readings.
//
// Planes through three readings, the one with most readings within the sensor's noise wins (Fischler
// and Bolles, RANSAC, 1981), refined on all of them. The random numbers have a fixed seed.
// Precondition: the image is one of the camera's, see CheckRgbdImage().
std::optional<Eigen::Vector3d> LevelSurfaceNormal(const RgbdImage& image, const CameraModel& camera,
                                                  const Eigen::Vector3d& expected_up_camera);

}  // namespace semantic_slam
