#pragma once

#include <image_transport/publisher.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/detection/detector.h"
#include "semantic_slam_ros/colour_stage.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/label_parameter.h"
#include "semantic_slam_ros/network_parameters.h"
#include "semantic_slam_ros/node_health.h"

namespace semantic_slam_ros {

// Everything that detection_node reads from its private parameters.
struct DetectionNodeParameters {
  ModelOptions model;
  semantic_slam::NetworkOptions network;
  semantic_slam::DetectorOptions detector;
  LabelOptions labels;
  ColourStageOptions stage;
  ColourInputOptions input;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.model);
    visit("", self.network);
    visit("", self.detector);
    visit("", self.labels);
    visit("", self.stage);
    visit("", self.input);
  }
};

// Wires Detector to topics; docs/ros_api.md lists them. It works on a thread of its own, and only
// while somebody subscribes to what it makes.
class DetectionNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  DetectionNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  DetectionNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                const DetectionNodeParameters& parameters);

  bool IsWanted() const;
  void Process(const ColourMessage& message, const ColourImage& image);
  void Diagnose(NodeHealth::Status& status) const;

  const semantic_slam::LabelVocabulary vocabulary_;
  const semantic_slam::Model model_;
  semantic_slam::Detector detector_;  // for the stage's thread
  DropCounter drops_;
  const ros::Publisher labels_pub_;
  const ros::Publisher detections_pub_;
  const image_transport::Publisher overlay_pub_;
  NodeHealth health_;
  ColourStage stage_;  // last: its thread uses all of the above
};

}  // namespace semantic_slam_ros
