#pragma once

#include <mutex>
#include <optional>
#include <string>

#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam_ros/transform_tree.h"

namespace semantic_slam_ros {

// Where the camera really was, where a motion capture system says so on the topic tf_ground_truth (a
// recorded /tf, remapped). Published as ground_truth_path, laid on the map by the first image that
// both know, so that people see the two side by side; and kept for the run's report.
//
// It keeps at most two million transforms. Publish() and CameraPath() may run on another thread than
// the callback.
class GroundTruth {
 public:
  // `world_frame` is the frame of the reference system, "world" in the TUM bags.
  GroundTruth(ros::NodeHandle nh, std::string world_frame, std::string map_frame);

  // Publishes the path so far if somebody listens and a second of stamps has passed.
  void Publish(const semantic_slam::TrackedImage& image, const std::string& camera_frame);

  // Poses T_world_camera so far; empty if nobody told.
  semantic_slam::Trajectory CameraPath(const std::string& camera_frame) const;

 private:
  void OnTransforms(const tf2_msgs::TFMessageConstPtr& msg);
  bool Align(const semantic_slam::TrackedImage& image, const semantic_slam::Trajectory& path);

  const std::string world_frame_;
  const std::string map_frame_;
  mutable std::mutex mutex_;
  TransformTree tree_;           // guarded by mutex_
  std::size_t transforms_ = 0;   // guarded by mutex_
  std::optional<semantic_slam::Rigid3d> T_map_world_;
  int aligned_map_id_ = -1;
  std::optional<semantic_slam::Stamp> published_;
  ros::Publisher path_pub_;
  ros::Subscriber tf_sub_;
};

}  // namespace semantic_slam_ros
