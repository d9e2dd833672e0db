#include "semantic_slam_ros/segmentation_node.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <image_transport/image_transport.h>

#include "semantic_slam/segmentation/segmentation_overlay.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::Segmentation;

SegmentationNode::SegmentationNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : SegmentationNode(nh, private_nh, ReadParameters<SegmentationNodeParameters>(private_nh)) {}

SegmentationNode::SegmentationNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                                   const SegmentationNodeParameters& parameters)
    : vocabulary_(LoadLabels(private_nh, parameters.labels)),
      model_(LoadModel(private_nh, parameters.model)),
      segmenter_(model_, vocabulary_, parameters.network),
      labels_pub_(PublishLabels(nh, vocabulary_)),
      image_pub_(nh.advertise<semantic_slam::SemanticImage>(topics::kSemanticImage, 1)),
      overlay_pub_(image_transport::ImageTransport(nh).advertise(topics::kSemanticOverlay, 1)),
      health_(nh, private_nh, "segmentation", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      stage_(
          nh, parameters.input, parameters.stage, drops_, [this] { return IsWanted(); },
          [this](const ColourMessage& message, const ColourImage& image) {
            Process(message, image);
          }) {}

bool SegmentationNode::IsWanted() const {
  return image_pub_.getNumSubscribers() > 0 || overlay_pub_.getNumSubscribers() > 0;
}

void SegmentationNode::Process(const ColourMessage& message, const ColourImage& image) {
  const Segmentation found = segmenter_.Segment(image.pixels, image.order, message.stamp);
  image_pub_.publish(ToSemanticImage(found, message.frame_id));
  if (overlay_pub_.getNumSubscribers() > 0) {
    const cv::Mat overlay =
        semantic_slam::DrawSegmentation(image.pixels, image.order, found, vocabulary_);
    overlay_pub_.publish(
        ToImage(ColourImage{overlay, image.order}, MakeHeader(message.stamp, message.frame_id)));
  }
  health_.AddLatency(message.received);
}

void SegmentationNode::Diagnose(NodeHealth::Status& status) const {
  const std::int64_t images = health_.processed();
  if (!IsWanted()) {
    status.summary(DiagnosticStatus::OK, "idle: nobody subscribes");
  } else if (images == 0) {
    status.summary(DiagnosticStatus::WARN, "no image has been segmented yet");
  } else {
    status.summary(DiagnosticStatus::OK, "segmenting");
  }
  status.add("images", images);
  status.add("model card", model_.card.path);
}

}  // namespace semantic_slam_ros
