#pragma once

#include <memory>

#include <ros/node_handle.h>
#include <semantic_slam/SemanticImage.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp_joiner.h"
#include "semantic_slam/semantic_cloud/cloud_builder.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/node_health.h"
#include "semantic_slam_ros/rgbd_input.h"
#include "semantic_slam_ros/stage_worker.h"

namespace semantic_slam_ros {

struct SemanticCloudNodeOptions {
  int queue_size =
      2;  // segmented images waiting for their turn; the oldest goes when another comes
  int max_waiting_images = 30;  // images that wait for their segmentation; the oldest goes likewise

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("queue_size", self.queue_size, 1, 1000);
    visit("max_waiting_images", self.max_waiting_images, 1, 1000);
  }
};

// Everything that semantic_cloud_node reads from its private parameters.
struct SemanticCloudNodeParameters {
  SemanticCloudNodeOptions node;
  LabelOptions labels;
  RgbdInputOptions input;
  semantic_slam::ImagePairerOptions pairer;
  semantic_slam::CloudBuilderOptions cloud;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    visit("", self.labels);
    visit("", self.input);
    visit("pairer", self.pairer);
    visit("cloud", self.cloud);
  }
};

// Wires CloudBuilder to topics; docs/ros_api.md lists them. Callbacks only sort pointers: decoding
// and the rest happen on a thread of its own, and only while somebody subscribes to the clouds.
class SemanticCloudNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  SemanticCloudNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  using Joiner = semantic_slam::StampJoiner<RgbdMessages, semantic_slam::SemanticImageConstPtr>;

  SemanticCloudNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                    const SemanticCloudNodeParameters& parameters);

  void OnImage(RgbdMessages messages);
  void OnSemanticImage(const semantic_slam::SemanticImageConstPtr& msg);
  void HandOut(std::optional<Joiner::Joined> joined);
  void Process(const Joiner::Joined& joined);
  const semantic_slam::CloudBuilder& BuilderFor(const RgbdMessages& messages);
  void Diagnose(NodeHealth::Status& status) const;

  const semantic_slam::LabelVocabulary vocabulary_;
  const semantic_slam::CloudBuilderOptions cloud_options_;
  DropCounter drops_;
  Joiner joiner_;                     // for the spinning thread
  std::size_t counted_unjoined_ = 0;  // what of the joiner's count is in drops_ already
  std::shared_ptr<const semantic_slam::CameraIntrinsics> intrinsics_;  // for the worker's thread
  std::unique_ptr<const semantic_slam::CloudBuilder> builder_;         // the same; of intrinsics_
  const ros::Publisher cloud_pub_;
  NodeHealth health_;
  std::unique_ptr<StageWorker<Joiner::Joined>> worker_;
  std::unique_ptr<RgbdInput> input_;  // after the worker it feeds
  ros::Subscriber semantic_sub_;      // the same
};

}  // namespace semantic_slam_ros
