#include "semantic_slam_ros/detection_node.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <image_transport/image_transport.h>

#include "semantic_slam/detection/detection_overlay.h"
#include "semantic_slam_ros/object_conversions.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::Detections;

DetectionNode::DetectionNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : DetectionNode(nh, private_nh, ReadParameters<DetectionNodeParameters>(private_nh)) {}

DetectionNode::DetectionNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                             const DetectionNodeParameters& parameters)
    : vocabulary_(LoadLabels(private_nh, parameters.labels)),
      model_(LoadModel(private_nh, parameters.model)),
      detector_(model_, vocabulary_, parameters.network, parameters.detector),
      labels_pub_(PublishLabels(nh, vocabulary_)),
      detections_pub_(nh.advertise<semantic_slam::DetectionArray>(topics::kDetections, 1)),
      overlay_pub_(image_transport::ImageTransport(nh).advertise(topics::kDetectionOverlay, 1)),
      health_(nh, private_nh, "detection", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      stage_(
          nh, parameters.input, parameters.stage, drops_, [this] { return IsWanted(); },
          [this](const ColourMessage& message, const ColourImage& image) {
            Process(message, image);
          }) {}

bool DetectionNode::IsWanted() const {
  return detections_pub_.getNumSubscribers() > 0 || overlay_pub_.getNumSubscribers() > 0;
}

void DetectionNode::Process(const ColourMessage& message, const ColourImage& image) {
  const Detections found = detector_.Detect(image.pixels, image.order, message.stamp);
  detections_pub_.publish(ToDetectionArray(found, message.frame_id));
  if (overlay_pub_.getNumSubscribers() > 0) {
    const cv::Mat overlay =
        semantic_slam::DrawDetections(image.pixels, image.order, found, vocabulary_);
    overlay_pub_.publish(
        ToImage(ColourImage{overlay, image.order}, MakeHeader(message.stamp, message.frame_id)));
  }
  health_.AddLatency(message.received);
}

void DetectionNode::Diagnose(NodeHealth::Status& status) const {
  const std::int64_t images = health_.processed();
  if (!IsWanted()) {
    status.summary(DiagnosticStatus::OK, "idle: nobody subscribes");
  } else if (images == 0) {
    status.summary(DiagnosticStatus::WARN, "no image has been looked at yet");
  } else {
    status.summary(DiagnosticStatus::OK, "detecting");
  }
  status.add("images", images);
  status.add("model card", model_.card.path);
}

}  // namespace semantic_slam_ros
