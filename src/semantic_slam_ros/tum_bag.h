#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/camera/camera_config.h"

namespace semantic_slam_ros {

// What the driver tells of the Kinect in the published TUM bags' camera_info: no distortion.
semantic_slam::CameraConfig PublishedTumCamera();

struct TumBagOptions {
  semantic_slam::CameraConfig camera = PublishedTumCamera();
  // The part to write, in seconds after the first image; with a second of everything but images
  // before and after. All of the folder unless given.
  double start_s = 0.0;
  std::optional<double> duration_s;
};

struct TumBagReport {
  std::size_t colour = 0;  // images written
  std::size_t depth = 0;
  std::size_t poses = 0;
  std::size_t accelerometer = 0;
  std::size_t dropped = 0;            // images that could not be read
  std::vector<std::string> problems;  // why, of the first few
};

// Writes a TUM folder as a bag with the topics and frames of the published TUM bags, in order of
// time and stamped as recorded:
//
//   /camera/rgb/image_color    sensor_msgs/Image, rgb8, in openni_rgb_optical_frame
//   /camera/rgb/camera_info    with every image; the calibration is `options.camera`'s
//   /camera/depth/image        sensor_msgs/Image, 32FC1 [m], registered to colour
//   /camera/depth/camera_info  the same calibration
//   /imu                       sensor_msgs/Imu, acceleration only, in frame imu
//   /tf                        world -> kinect -> openni_camera -> openni_rgb_frame ->
//                              openni_rgb_optical_frame, whose product is groundtruth.txt's pose at
//                              its stamps; also openni_depth_frame, openni_depth_optical_frame
//                              and imu. Without groundtruth.txt all but the first link, with
//                              every colour image
//
// Calls `on_message(done, all)` after every message. The bag is complete or absent. Throws
// InputError in one line if the folder or a list is missing or malformed, if there is no image in
// the part asked for, or if the bag cannot be written.
TumBagReport WriteTumBag(const std::string& folder, const std::string& bag_path,
                         const TumBagOptions& options,
                         const std::function<void(std::size_t, std::size_t)>& on_message = {});

}  // namespace semantic_slam_ros
