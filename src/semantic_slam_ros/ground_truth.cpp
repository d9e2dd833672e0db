#include "semantic_slam_ros/ground_truth.h"

#include <cmath>
#include <utility>

#include <nav_msgs/Path.h>
#include <ros/console.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/tracking_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::SecondsBetween;
using semantic_slam::StampedPose;
using semantic_slam::TrackedImage;
using semantic_slam::Trajectory;

namespace {

constexpr int kQueueSize = 1000;  // a recorded /tf comes in bursts
constexpr std::size_t kMaxTransforms = 2'000'000;
constexpr double kPublishPeriodS = 1.0;
constexpr double kMaxGapS = 0.02;

}  // namespace

GroundTruth::GroundTruth(ros::NodeHandle nh, std::string world_frame, std::string map_frame)
    : world_frame_(std::move(world_frame)),
      map_frame_(std::move(map_frame)),
      path_pub_(nh.advertise<nav_msgs::Path>(topics::kGroundTruthPath, 1, true)),
      tf_sub_(nh.subscribe(topics::kGroundTruthTf, kQueueSize, &GroundTruth::OnTransforms, this)) {}

void GroundTruth::OnTransforms(const tf2_msgs::TFMessageConstPtr& msg) {
  std::lock_guard<std::mutex> lock(mutex_);
  for (const geometry_msgs::TransformStamped& link : msg->transforms) {
    if (transforms_ == kMaxTransforms) {
      ROS_WARN_ONCE("ground truth is no longer recorded: there are %zu transforms", kMaxTransforms);
      return;
    }
    try {
      tree_.Add(FrameName(link.header.frame_id), FrameName(link.child_frame_id),
                ToStamp(link.header.stamp), ToRigid(link.transform));
      ++transforms_;
    } catch (const semantic_slam::InputError& e) {
      ROS_WARN_THROTTLE(5.0, "ground truth from %s to %s is left out: %s",
                        link.header.frame_id.c_str(), link.child_frame_id.c_str(), e.what());
    }
  }
}

void GroundTruth::Publish(const TrackedImage& image, const std::string& camera_frame) {
  if (image.status != semantic_slam::TrackingStatus::kTracking) return;
  if (published_ && image.stamp >= *published_ &&
      SecondsBetween(*published_, image.stamp) < kPublishPeriodS) {
    return;
  }
  if (T_map_world_ && path_pub_.getNumSubscribers() == 0) return;
  Trajectory path = CameraPath(camera_frame);
  if (path.empty() || !Align(image, path)) return;
  published_ = image.stamp;
  for (StampedPose& pose : path) pose.pose = *T_map_world_ * pose.pose;
  path_pub_.publish(ToPath(path, map_frame_));
}

Trajectory GroundTruth::CameraPath(const std::string& camera_frame) const {
  std::lock_guard<std::mutex> lock(mutex_);
  return tree_.Path(world_frame_, camera_frame);
}

// Lays the path on the map by the pose nearest to the image, once per map.
bool GroundTruth::Align(const TrackedImage& image, const Trajectory& path) {
  if (T_map_world_ && aligned_map_id_ == image.map_id) return true;
  const StampedPose* nearest = nullptr;
  double smallest_gap_s = kMaxGapS;
  for (const StampedPose& pose : path) {
    const double gap_s = std::abs(SecondsBetween(pose.stamp, image.stamp));
    if (gap_s <= smallest_gap_s) nearest = &pose, smallest_gap_s = gap_s;
  }
  if (nearest == nullptr) return false;
  T_map_world_ = image.T_map_camera * nearest->pose.inverse();
  aligned_map_id_ = image.map_id;
  return true;
}

}  // namespace semantic_slam_ros
