#pragma once

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>

#include <ros/node_handle.h>
#include <semantic_slam/DetectionArray.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp_joiner.h"
#include "semantic_slam/object_tracking/object_tracker.h"
#include "semantic_slam_ros/colour_input.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/stage_worker.h"

namespace semantic_slam_ros {

struct ObjectTrackingNodeOptions {
  int queue_size = 5;  // detections waiting for their turn; the oldest goes when another comes
  int max_waiting_images = 30;  // images that wait for their detections; the oldest goes likewise

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("queue_size", self.queue_size, 1, 1000);
    visit("max_waiting_images", self.max_waiting_images, 1, 1000);
  }
};

// Everything that object_tracking_node reads from its private parameters.
struct ObjectTrackingNodeParameters {
  ObjectTrackingNodeOptions node;
  LabelOptions labels;
  ColourInputOptions input;
  semantic_slam::ObjectTrackingOptions tracking;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.labels);
    visit("", self.input);
    semantic_slam::ObjectTrackingOptions::VisitGroups(self.tracking, visit);
  }
};

// Wires ObjectTracker to topics; docs/ros_api.md lists them. Callbacks only sort pointers: decoding
// and tracking happen on a thread of its own.
class ObjectTrackingNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  ObjectTrackingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  struct Received {
    semantic_slam::DetectionArrayConstPtr msg;
    std::chrono::steady_clock::time_point at;
  };
  // Detections, and their image where the camera's motion is wanted.
  struct Input {
    Received detections;
    std::optional<ColourMessage> image;
  };
  using Joiner = semantic_slam::StampJoiner<ColourMessage, Received>;

  ObjectTrackingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                     const ObjectTrackingNodeParameters& parameters);

  void OnImage(ColourMessage message);
  void OnDetections(const semantic_slam::DetectionArrayConstPtr& msg);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  void HandOut(std::optional<Joiner::Joined> joined);
  void Process(const Input& input);
  cv::Mat Decode(const Input& input);
  void Diagnose(NodeHealth::Status& status) const;

  const std::shared_ptr<const semantic_slam::LabelVocabulary> vocabulary_;
  DropCounter drops_;
  Joiner joiner_;                     // for the spinning thread
  std::size_t counted_unjoined_ = 0;  // what of the joiner's count is in drops_ already
  mutable std::mutex mutex_;
  semantic_slam::ObjectTracker tracker_;  // guarded by mutex_
  std::size_t tracks_ = 0;                // guarded by mutex_
  const ros::Publisher tracks_pub_;
  NodeHealth health_;
  std::unique_ptr<StageWorker<Input>> worker_;
  std::unique_ptr<ColourInput> input_;  // after the worker it feeds; none if no image is wanted
  ros::Subscriber detections_sub_;
  ros::ServiceServer reset_service_;
};

}  // namespace semantic_slam_ros
