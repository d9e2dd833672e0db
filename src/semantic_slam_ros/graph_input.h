#pragma once

#include <functional>

#include <ros/node_handle.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/TrackingState.h>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// Subscribes to what tracking tells, image by image and about the keyframe graph: how every map
// follows the camera (docs/frames.md). Malformed messages are counted under bad_tracking_state and
// bad_keyframes. For one spinning thread.
class GraphInput {
 public:
  using TrackedCallback = std::function<void(const semantic_slam::TrackedImage&)>;
  using GraphCallback = std::function<void(semantic_slam::KeyframeGraph)>;

  // A callback may be empty: its topic is not subscribed to then. `drops` must outlive this.
  GraphInput(ros::NodeHandle nh, DropCounter& drops, TrackedCallback on_tracked,
             GraphCallback on_graph);

 private:
  void OnTrackingState(const semantic_slam::TrackingState& msg);
  void OnKeyframes(const semantic_slam::KeyframeArray& msg);

  DropCounter& drops_;
  const TrackedCallback on_tracked_;
  const GraphCallback on_graph_;
  // Last, so that no callback finds a member gone.
  ros::Subscriber state_sub_;
  ros::Subscriber keyframes_sub_;
};

}  // namespace semantic_slam_ros
