#pragma once

#include <string>
#include <variant>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>
#include <std_msgs/Header.h>

#include <opencv2/core.hpp>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/common/transform.h"
#include "semantic_slam/dataset/rgbd_source.h"

// ROS messages to the core's types and back. Every function throws semantic_slam::InputError with
// one line that names the fault if the message is malformed; none keeps state.

namespace semantic_slam_ros {

using semantic_slam::Rigid3d;
using semantic_slam::Stamp;

Stamp ToStamp(const ros::Time& time);
// Precondition: the stamp is not negative and before the year 2106, as everything from ROS is.
ros::Time ToRos(Stamp stamp);

// "/camera" -> "camera": tf2 knows no leading slash, messages from before 2013 have one.
std::string FrameName(const std::string& frame_id);

std_msgs::Header MakeHeader(Stamp stamp, const std::string& frame_id);

struct ColourImage {
  cv::Mat pixels;  // H x W, CV_8UC3
  semantic_slam::ColourOrder order;
};

// Encodings rgb8, bgr8 and 8UC3 (taken as BGR) are passed on without a copy: the pixels are the
// message's, and keep it alive. rgba8, bgra8, mono8 and 8UC1 are converted to BGR. Bayer patterns
// are refused: debayer them first.
ColourImage ToColour(const sensor_msgs::ImageConstPtr& msg);
ColourImage ToColour(const sensor_msgs::CompressedImage& msg);

// Depth along the optical axis [m], CV_32FC1. 32FC1 [m] is passed on without a copy, 16UC1 and
// mono16 [mm, 0 is "no return"] are converted, with NaN for "no return" (REP-117, REP-118).
cv::Mat ToDepthMetres(const sensor_msgs::ImageConstPtr& msg);
// The same from a 16-bit PNG, or from what compressed_depth_image_transport sends for 16UC1 and
// 32FC1 images ("...; compressedDepth", PNG inside).
cv::Mat ToDepthMetres(const sensor_msgs::CompressedImage& msg);

// An image as it came, not looked into yet.
using ImageMessage = std::variant<sensor_msgs::ImageConstPtr, sensor_msgs::CompressedImageConstPtr>;
ColourImage ToColour(const ImageMessage& msg);
cv::Mat ToDepthMetres(const ImageMessage& msg);

// K and D, as the images are raw. Refuses a calibration of zeros, a distortion model that is not
// plumb_bob or rational_polynomial, binning and a region of interest.
semantic_slam::CameraIntrinsics ToIntrinsics(const sensor_msgs::CameraInfo& msg);

// The linear acceleration. Refuses a message that says it has none (covariance[0] = -1).
semantic_slam::AccelerometerReading ToAccelerometerReading(const sensor_msgs::Imu& msg);

// Refuse numbers that are not finite and quaternions whose length is not 1 to 1 %.
Rigid3d ToRigid(const geometry_msgs::Pose& msg);
Rigid3d ToRigid(const geometry_msgs::Transform& msg);

geometry_msgs::Pose ToPose(const Rigid3d& T_frame_object);
geometry_msgs::Transform ToTransform(const Rigid3d& T_parent_child);
geometry_msgs::TransformStamped ToTransformStamped(Stamp stamp, const std::string& parent,
                                                   const std::string& child,
                                                   const Rigid3d& T_parent_child);

// A copy of the pixels; `encoding` says what they mean. Precondition: the encoding's pixel size is
// the image's.
sensor_msgs::ImagePtr ToImage(const cv::Mat& image, const std::string& encoding,
                              const std_msgs::Header& header);
sensor_msgs::ImagePtr ToImage(const ColourImage& image, const std_msgs::Header& header);

// K and D of a raw image; R is identity and P is K without distortion.
sensor_msgs::CameraInfo ToCameraInfo(const semantic_slam::CameraIntrinsics& intrinsics,
                                     const std_msgs::Header& header);

}  // namespace semantic_slam_ros
