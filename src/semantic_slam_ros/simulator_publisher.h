#pragma once

#include <string>
#include <vector>

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam/simulation/simulated_flight.h"
#include "semantic_slam_ros/simulator_parameters.h"

namespace semantic_slam_ros {

// Tells the world what the simulated sensors see, and the truth. Images are published as shared
// pointers, so within a nodelet manager nobody copies them. For one thread, but for has_listener().
class SimulatorPublisher {
 public:
  // Publishes where the camera and the imu sit, and the vocabulary, at once. `vocabulary` must
  // outlive this.
  SimulatorPublisher(ros::NodeHandle nh, const SimulatorFrameOptions& frames,
                     const semantic_slam::SimulatedFlightOptions& flight,
                     const semantic_slam::LabelVocabulary& vocabulary,
                     const semantic_slam::CameraIntrinsics& intrinsics);

  void PublishClock(semantic_slam::Stamp stamp);
  void PublishCameraInfo(semantic_slam::Stamp stamp);
  void PublishReadings(const std::vector<semantic_slam::ImuReading>& readings);
  void PublishTruth(const semantic_slam::SimulatedFlight& flight);
  void PublishImages(const semantic_slam::RgbdImage& image);
  // What networks would find in the image; for people, if they subscribe, drawn into it.
  void PublishSegmentation(const semantic_slam::Segmentation& segmentation,
                           const semantic_slam::RgbdImage& image);
  void PublishDetections(const semantic_slam::Detections& detections,
                         const semantic_slam::RgbdImage& image);

  // Somebody receives both images and the calibration.
  bool has_listener() const;
  bool wants_segmentation() const {
    return semantic_image_pub_.getNumSubscribers() + semantic_overlay_pub_.getNumSubscribers() > 0;
  }
  bool wants_detections() const {
    return detections_pub_.getNumSubscribers() + detection_overlay_pub_.getNumSubscribers() > 0;
  }

 private:
  void PublishMount(const semantic_slam::SensorMountOptions& mount);
  void PublishOverlay(const image_transport::Publisher& publisher, const cv::Mat& overlay,
                      const semantic_slam::RgbdImage& image) const;

  const SimulatorFrameOptions frames_;
  const std::string truth_frame_;
  const semantic_slam::ImuOptions imu_options_;
  const double imu_rate_hz_;
  const semantic_slam::CameraIntrinsics intrinsics_;
  const semantic_slam::LabelVocabulary& vocabulary_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher clock_pub_;
  ros::Publisher imu_pub_;
  ros::Publisher truth_tf_pub_;
  ros::Publisher truth_odometry_pub_;
  ros::Publisher info_pub_;
  ros::Publisher depth_pub_;
  ros::Publisher colour_pub_;
  ros::Publisher labels_pub_;
  ros::Publisher semantic_image_pub_;
  ros::Publisher detections_pub_;
  image_transport::Publisher semantic_overlay_pub_;
  image_transport::Publisher detection_overlay_pub_;
};

}  // namespace semantic_slam_ros
