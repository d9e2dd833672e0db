#include "semantic_slam_ros/graph_input.h"

#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/topics.h"
#include "semantic_slam_ros/tracking_conversions.h"

namespace semantic_slam_ros {

using semantic_slam::InputError;

namespace {

// Every image's state counts, also those that come while a callback is busy: half a minute of them.
constexpr int kStateQueueSize = 1000;
constexpr int kKeyframesQueueSize = 10;  // each message is the whole graph

}  // namespace

GraphInput::GraphInput(ros::NodeHandle nh, DropCounter& drops, TrackedCallback on_tracked,
                       GraphCallback on_graph)
    : drops_(drops), on_tracked_(std::move(on_tracked)), on_graph_(std::move(on_graph)) {
  if (on_tracked_) {
    state_sub_ = nh.subscribe(topics::kTrackingState, kStateQueueSize, &GraphInput::OnTrackingState,
                              this, ros::TransportHints().tcpNoDelay());
  }
  if (on_graph_) {
    keyframes_sub_ =
        nh.subscribe(topics::kKeyframes, kKeyframesQueueSize, &GraphInput::OnKeyframes, this);
  }
}

void GraphInput::OnTrackingState(const semantic_slam::TrackingState& msg) {
  semantic_slam::TrackedImage image;
  try {
    image = ToTrackedImage(msg);
  } catch (const InputError& e) {
    drops_.Add("bad_tracking_state", e.what());
    return;
  }
  on_tracked_(image);
}

void GraphInput::OnKeyframes(const semantic_slam::KeyframeArray& msg) {
  semantic_slam::KeyframeGraph graph;
  try {
    graph = ToKeyframeGraph(msg);
  } catch (const InputError& e) {
    drops_.Add("bad_keyframes", e.what());
    return;
  }
  on_graph_(std::move(graph));
}

}  // namespace semantic_slam_ros
