#include "semantic_slam_ros/simulator_publisher.h"

#include <boost/make_shared.hpp>

#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/image_encodings.h>
#include <tf2_msgs/TFMessage.h>

#include "semantic_slam/detection/detection_overlay.h"
#include "semantic_slam/segmentation/segmentation_overlay.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/network_parameters.h"
#include "semantic_slam_ros/object_conversions.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/simulator_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::Detections;
using semantic_slam::ImuReading;
using semantic_slam::RgbdImage;
using semantic_slam::Segmentation;
using semantic_slam::SimulatedFlight;

namespace {

constexpr int kQueueSize = 10;
constexpr int kImuQueueSize = 1000;  // readings are published in bursts, one per image

SimulatorFrameOptions WithoutSlashes(SimulatorFrameOptions frames) {
  for (std::string* frame : {&frames.world_frame, &frames.base_frame, &frames.camera_frame,
                             &frames.optical_frame, &frames.imu_frame}) {
    *frame = FrameName(*frame);
  }
  return frames;
}

}  // namespace

SimulatorPublisher::SimulatorPublisher(ros::NodeHandle nh, const SimulatorFrameOptions& frames,
                                       const semantic_slam::SimulatedFlightOptions& flight,
                                       const semantic_slam::LabelVocabulary& vocabulary,
                                       const semantic_slam::CameraIntrinsics& intrinsics)
    : frames_(WithoutSlashes(frames)),
      truth_frame_("ground_truth/" + frames_.base_frame),
      imu_options_(flight.imu),
      imu_rate_hz_(flight.mount.imu_rate_hz),
      intrinsics_(intrinsics),
      vocabulary_(vocabulary),
      clock_pub_(nh.advertise<rosgraph_msgs::Clock>(topics::kClock, kQueueSize)),
      imu_pub_(nh.advertise<sensor_msgs::Imu>(topics::kImu, kImuQueueSize)),
      truth_tf_pub_(nh.advertise<tf2_msgs::TFMessage>(topics::kGroundTruthTf, kQueueSize)),
      truth_odometry_pub_(
          nh.advertise<nav_msgs::Odometry>(topics::kGroundTruthOdometry, kQueueSize)),
      info_pub_(nh.advertise<sensor_msgs::CameraInfo>(topics::kCameraInfo, kQueueSize)),
      depth_pub_(nh.advertise<sensor_msgs::Image>(topics::kDepth, kQueueSize)),
      colour_pub_(nh.advertise<sensor_msgs::Image>(topics::kColour, kQueueSize)),
      labels_pub_(PublishLabels(nh, vocabulary)),
      semantic_image_pub_(
          nh.advertise<semantic_slam::SemanticImage>(topics::kSemanticImage, kQueueSize)),
      detections_pub_(nh.advertise<semantic_slam::DetectionArray>(topics::kDetections, kQueueSize)),
      semantic_overlay_pub_(
          image_transport::ImageTransport(nh).advertise(topics::kSemanticOverlay, 1)),
      detection_overlay_pub_(
          image_transport::ImageTransport(nh).advertise(topics::kDetectionOverlay, 1)) {
  PublishMount(flight.mount);
}

void SimulatorPublisher::PublishMount(const semantic_slam::SensorMountOptions& mount) {
  const Rigid3d T_housing_optical = semantic_slam::OpticalInHousing();
  static_broadcaster_.sendTransform(std::vector<geometry_msgs::TransformStamped>{
      ToTransformStamped(Stamp(), frames_.base_frame, frames_.camera_frame, HousingPose(mount)),
      ToTransformStamped(Stamp(), frames_.camera_frame, frames_.optical_frame, T_housing_optical),
      ToTransformStamped(Stamp(), frames_.camera_frame, frames_.imu_frame, T_housing_optical)});
}

void SimulatorPublisher::PublishClock(Stamp stamp) {
  rosgraph_msgs::Clock msg;
  msg.clock = ToRos(stamp);
  clock_pub_.publish(msg);
}

void SimulatorPublisher::PublishCameraInfo(Stamp stamp) {
  info_pub_.publish(ToCameraInfo(intrinsics_, MakeHeader(stamp, frames_.optical_frame)));
}

void SimulatorPublisher::PublishReadings(const std::vector<ImuReading>& readings) {
  for (const ImuReading& reading : readings) {
    imu_pub_.publish(ToImu(reading, imu_options_, imu_rate_hz_, frames_.imu_frame));
  }
}

void SimulatorPublisher::PublishTruth(const SimulatedFlight& flight) {
  const Stamp stamp = flight.stamp();
  broadcaster_.sendTransform(
      ToTransformStamped(stamp, frames_.world_frame, truth_frame_, flight.state().T_world_base));
  // What a motion capture system would say of the camera; not on /tf, where the camera is the
  // estimate's.
  tf2_msgs::TFMessage truth;
  truth.transforms.push_back(ToTransformStamped(stamp, frames_.world_frame, frames_.optical_frame,
                                                flight.T_world_camera()));
  truth_tf_pub_.publish(truth);
  truth_odometry_pub_.publish(ToOdometry(flight.state(), stamp, frames_.world_frame, truth_frame_));
}

void SimulatorPublisher::PublishImages(const RgbdImage& image) {
  const std_msgs::Header header = MakeHeader(image.stamp, frames_.optical_frame);
  PublishCameraInfo(image.stamp);
  depth_pub_.publish(ToImage(image.depth_m, sensor_msgs::image_encodings::TYPE_32FC1, header));
  colour_pub_.publish(ToImage(ColourImage{image.colour, image.order}, header));
}

void SimulatorPublisher::PublishSegmentation(const Segmentation& segmentation,
                                             const RgbdImage& image) {
  semantic_image_pub_.publish(ToSemanticImage(segmentation, frames_.optical_frame));
  if (semantic_overlay_pub_.getNumSubscribers() == 0) return;
  PublishOverlay(semantic_overlay_pub_,
                 DrawSegmentation(image.colour, image.order, segmentation, vocabulary_), image);
}

void SimulatorPublisher::PublishDetections(const Detections& detections, const RgbdImage& image) {
  detections_pub_.publish(ToDetectionArray(detections, frames_.optical_frame));
  if (detection_overlay_pub_.getNumSubscribers() == 0) return;
  PublishOverlay(detection_overlay_pub_,
                 DrawDetections(image.colour, image.order, detections, vocabulary_), image);
}

void SimulatorPublisher::PublishOverlay(const image_transport::Publisher& publisher,
                                        const cv::Mat& overlay, const RgbdImage& image) const {
  publisher.publish(
      ToImage(ColourImage{overlay, image.order}, MakeHeader(image.stamp, frames_.optical_frame)));
}

bool SimulatorPublisher::has_listener() const {
  return info_pub_.getNumSubscribers() > 0 && depth_pub_.getNumSubscribers() > 0 &&
         colour_pub_.getNumSubscribers() > 0;
}

}  // namespace semantic_slam_ros
