#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/dataset/rgbd_source.h"

namespace semantic_slam {

// The start pose that puts the map's z axis up, its x axis along the camera's view (projected to
// the horizontal) and its origin at the camera.
//
//   up_camera  any length; points up, in the camera's optical frame. At rest that is what an
//              accelerometer reads.
//
// Throws InputError if `up_camera` is not finite or has no direction.
Rigid3d StartPoseFromUp(const Eigen::Vector3d& up_camera);

// Mean specific force over the readings from `window_s` before `stamp` to `window_s` after, in the
// accelerometer's axes. nullopt if there are fewer than three or their mean is not within 20 % of
// 9.81 m/s^2: then it was not gravity.
std::optional<Eigen::Vector3d> MeanAcceleration(const std::vector<AccelerometerReading>& readings,
                                                Stamp stamp, double window_s = 0.5);

// Where a map begins, and how it was known which way is up.
struct MapStart {
  Rigid3d T_map_camera;
  std::string source;  // a clause for the log: "up from the imu"
};

// The start of a map whose first image is `image`: z up, origin at the base frame. Up comes from
// `up_by_imu_camera` (an accelerometer's mean reading, optical frame) if it is given; else from the
// largest level surface in view, see LevelSurfaceNormal(); else the base is taken to stand level.
// With the first two the camera looks along x, with the last one the base does. Throws InputError if
// the image is not one of the camera's, see CheckRgbdImage().
MapStart FindMapStart(const std::optional<Eigen::Vector3d>& up_by_imu_camera,
                      const RgbdImage& image, const CameraModel& camera,
                      const Rigid3d& T_base_camera);

}  // namespace semantic_slam
