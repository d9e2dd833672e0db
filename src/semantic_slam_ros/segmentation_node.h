#pragma once

#include <image_transport/publisher.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/segmentation/segmenter.h"
#include "semantic_slam_ros/colour_stage.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/network_parameters.h"
#include "semantic_slam_ros/node_health.h"

namespace semantic_slam_ros {

// Everything that segmentation_node reads from its private parameters.
struct SegmentationNodeParameters {
  ModelOptions model;
  semantic_slam::NetworkOptions network;
  LabelOptions labels;
  ColourStageOptions stage;
  ColourInputOptions input;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.model);
    visit("", self.network);
    visit("", self.labels);
    visit("", self.stage);
    visit("", self.input);
  }
};

// Wires Segmenter to topics; docs/ros_api.md lists them. It works on a thread of its own, and only
// while somebody subscribes to what it makes.
class SegmentationNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  SegmentationNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  SegmentationNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                   const SegmentationNodeParameters& parameters);

  bool IsWanted() const;
  void Process(const ColourMessage& message, const ColourImage& image);
  void Diagnose(NodeHealth::Status& status) const;

  const semantic_slam::LabelVocabulary vocabulary_;
  const semantic_slam::Model model_;
  semantic_slam::Segmenter segmenter_;  // for the stage's thread
  DropCounter drops_;
  const ros::Publisher labels_pub_;
  const ros::Publisher image_pub_;
  const image_transport::Publisher overlay_pub_;
  NodeHealth health_;
  ColourStage stage_;  // last: its thread uses all of the above
};

}  // namespace semantic_slam_ros
