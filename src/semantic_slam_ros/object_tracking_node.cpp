#include "semantic_slam_ros/object_tracking_node.h"

#include <algorithm>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <semantic_slam/TrackedObjectArray.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/object_conversions.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::ObjectTracks;

namespace {

// Detections wait for their image only as long as it takes another way.
constexpr std::size_t kMaxWaitingResults = 5;
constexpr int kTopicQueueSize = 10;

std::size_t CountConfirmed(const ObjectTracks& tracks) {
  return static_cast<std::size_t>(std::count_if(
      tracks.tracks.begin(), tracks.tracks.end(), [](const semantic_slam::ObjectTrack& track) {
        return track.state == semantic_slam::TrackState::kConfirmed;
      }));
}

}  // namespace

ObjectTrackingNode::ObjectTrackingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : ObjectTrackingNode(nh, private_nh, ReadParameters<ObjectTrackingNodeParameters>(private_nh)) {
}

ObjectTrackingNode::ObjectTrackingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                                       const ObjectTrackingNodeParameters& parameters)
    : vocabulary_(std::make_shared<const semantic_slam::LabelVocabulary>(
          LoadLabels(private_nh, parameters.labels))),
      joiner_(static_cast<std::size_t>(parameters.node.max_waiting_images), kMaxWaitingResults),
      tracker_(parameters.tracking, vocabulary_),
      tracks_pub_(nh.advertise<semantic_slam::TrackedObjectArray>(topics::kTrackedObjects, 10)),
      health_(nh, private_nh, "object tracking", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      worker_(std::make_unique<StageWorker<Input>>(
          parameters.node.queue_size, drops_, [this](const Input& input) { Process(input); })) {
  if (parameters.tracking.tracker.compensate_camera) {
    input_ = std::make_unique<ColourInput>(
        nh, parameters.input, drops_,
        [this](ColourMessage message) { OnImage(std::move(message)); });
  }
  detections_sub_ =
      nh.subscribe(topics::kDetections, kTopicQueueSize, &ObjectTrackingNode::OnDetections, this);
  reset_service_ = private_nh.advertiseService(topics::kReset, &ObjectTrackingNode::OnReset, this);
}

void ObjectTrackingNode::OnImage(ColourMessage message) {
  const semantic_slam::Stamp stamp = message.stamp;
  HandOut(joiner_.AddSource(stamp, std::move(message)));
}

void ObjectTrackingNode::OnDetections(const semantic_slam::DetectionArrayConstPtr& msg) {
  if (!HasStamp(msg->header, "detections", drops_)) return;
  Received received{msg, std::chrono::steady_clock::now()};
  if (input_ == nullptr) {
    worker_->Push({std::move(received), std::nullopt});
  } else {
    HandOut(joiner_.AddResult(ToStamp(msg->header.stamp), std::move(received)));
  }
}

void ObjectTrackingNode::HandOut(std::optional<Joiner::Joined> joined) {
  const std::size_t unjoined = joiner_.unjoined_results();
  if (unjoined > counted_unjoined_) drops_.AddQuietly("no_image", unjoined - counted_unjoined_);
  counted_unjoined_ = unjoined;
  if (joined) worker_->Push({std::move(joined->result), std::move(joined->source)});
}

void ObjectTrackingNode::Process(const Input& input) {
  const semantic_slam::DetectionArray& msg = *input.detections.msg;
  ObjectTracks tracks;
  try {
    const semantic_slam::Detections detections = ToDetections(msg, *vocabulary_);
    const cv::Mat image = Decode(input);
    std::lock_guard<std::mutex> lock(mutex_);
    tracks = tracker_.Update(detections, image);
    tracks_ = CountConfirmed(tracks);
  } catch (const InputError& e) {
    drops_.Add("bad_detections", e.what());
    return;
  }
  tracks_pub_.publish(ToTrackedObjectArray(tracks, FrameName(msg.header.frame_id)));
  health_.AddLatency(input.detections.at);
}

// Empty if there is none or it is malformed: tracking can do without.
cv::Mat ObjectTrackingNode::Decode(const Input& input) {
  if (!input.image) return {};
  try {
    return input.image->Decode().pixels;
  } catch (const InputError& e) {
    drops_.Add("bad_image", e.what());
    return {};
  }
}

bool ObjectTrackingNode::OnReset(std_srvs::Trigger::Request&,
                                 std_srvs::Trigger::Response& response) {
  std::lock_guard<std::mutex> lock(mutex_);
  tracker_.Reset();
  response.success = true;
  response.message = "all tracks have ended; ids go on";
  return true;
}

void ObjectTrackingNode::Diagnose(NodeHealth::Status& status) const {
  if (health_.processed() == 0) {
    status.summary(DiagnosticStatus::WARN, "no detections have been tracked yet");
  } else {
    status.summary(DiagnosticStatus::OK, "tracking objects");
  }
  status.add("images", health_.processed());
  std::lock_guard<std::mutex> lock(mutex_);
  status.add("objects in view", tracks_);
}

}  // namespace semantic_slam_ros
