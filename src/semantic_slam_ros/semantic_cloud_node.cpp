#include "semantic_slam_ros/semantic_cloud_node.h"

#include <string>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <sensor_msgs/PointCloud2.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::SemanticImageConstPtr;

namespace {

// A segmentation waits for its images only as long as those wait for each other.
constexpr std::size_t kMaxWaitingResults = 5;
constexpr int kTopicQueueSize = 5;

}  // namespace

SemanticCloudNode::SemanticCloudNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : SemanticCloudNode(nh, private_nh, ReadParameters<SemanticCloudNodeParameters>(private_nh)) {}

SemanticCloudNode::SemanticCloudNode(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                                     const SemanticCloudNodeParameters& parameters)
    : vocabulary_(LoadLabels(private_nh, parameters.labels)),
      cloud_options_(semantic_slam::Checked(parameters.cloud)),
      joiner_(static_cast<std::size_t>(parameters.node.max_waiting_images), kMaxWaitingResults),
      cloud_pub_(nh.advertise<sensor_msgs::PointCloud2>(topics::kSemanticCloud, 1)),
      health_(nh, private_nh, "semantic_cloud", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      worker_(std::make_unique<StageWorker<Joiner::Joined>>(
          parameters.node.queue_size, drops_,
          [this](const Joiner::Joined& joined) { Process(joined); })),
      input_(std::make_unique<RgbdInput>(
          nh, parameters.input, parameters.pairer, drops_,
          [this](RgbdMessages messages) { OnImage(std::move(messages)); })) {
  semantic_sub_ = nh.subscribe(topics::kSemanticImage, kTopicQueueSize,
                               &SemanticCloudNode::OnSemanticImage, this);
}

void SemanticCloudNode::OnImage(RgbdMessages messages) {
  const semantic_slam::Stamp stamp = messages.stamp;
  HandOut(joiner_.AddSource(stamp, std::move(messages)));
}

void SemanticCloudNode::OnSemanticImage(const SemanticImageConstPtr& msg) {
  if (!HasStamp(msg->header, "semantic image", drops_)) return;
  HandOut(joiner_.AddResult(ToStamp(msg->header.stamp), msg));
}

void SemanticCloudNode::HandOut(std::optional<Joiner::Joined> joined) {
  const std::size_t unjoined = joiner_.unjoined_results();
  if (unjoined > counted_unjoined_) drops_.AddQuietly("no_images", unjoined - counted_unjoined_);
  counted_unjoined_ = unjoined;
  if (joined && cloud_pub_.getNumSubscribers() > 0) worker_->Push(std::move(*joined));
}

void SemanticCloudNode::Process(const Joiner::Joined& joined) {
  const RgbdMessages& messages = joined.source;
  semantic_slam::Segmentation segmentation;
  try {
    segmentation = ToSegmentation(joined.result, vocabulary_);
  } catch (const InputError& e) {
    drops_.Add("bad_semantic_image", e.what());
    return;
  }
  try {
    const auto cloud = BuilderFor(messages).Build(messages.Decode(), segmentation);
    cloud_pub_.publish(ToPointCloud2(cloud, messages.frame_id));
  } catch (const InputError& e) {
    drops_.Add("bad_image", e.what());
    return;
  }
  health_.AddLatency(messages.received);
}

const semantic_slam::CloudBuilder& SemanticCloudNode::BuilderFor(const RgbdMessages& messages) {
  if (messages.intrinsics != intrinsics_) {
    const auto camera = std::make_shared<const semantic_slam::CameraModel>(*messages.intrinsics);
    builder_ = std::make_unique<const semantic_slam::CloudBuilder>(cloud_options_, camera);
    intrinsics_ = messages.intrinsics;
  }
  return *builder_;
}

void SemanticCloudNode::Diagnose(NodeHealth::Status& status) const {
  const std::int64_t clouds = health_.processed();
  if (cloud_pub_.getNumSubscribers() == 0) {
    status.summary(DiagnosticStatus::OK, "idle: nobody subscribes");
  } else if (clouds == 0) {
    status.summary(DiagnosticStatus::WARN, "no cloud has been made yet");
  } else {
    status.summary(DiagnosticStatus::OK, "making clouds");
  }
  status.add("clouds", clouds);
}

}  // namespace semantic_slam_ros
