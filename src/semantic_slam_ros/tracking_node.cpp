#include "semantic_slam_ros/tracking_node.h"

#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/evaluation/trajectory.h"
#include "semantic_slam/localization/run_report.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;

namespace {

void ReportChange(TrackingStatus before, const TrackedImage& now) {
  if (before == now.status) return;
  const std::string stamp = ToString(now.stamp);
  if (now.status == TrackingStatus::kLost) ROS_WARN("lost at %s s", stamp.c_str());
  if (now.status == TrackingStatus::kTracking) ROS_INFO("tracking from %s s", stamp.c_str());
}

TrackingNodeParameters WithoutSlashes(TrackingNodeParameters parameters) {
  TrackingPublisherOptions& frames = parameters.publisher;
  frames.map_frame = FrameName(frames.map_frame);
  frames.odom_frame = FrameName(frames.odom_frame);
  frames.base_frame = FrameName(frames.base_frame);
  return parameters;
}

}  // namespace

TrackingNode::TrackingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : TrackingNode(nh, private_nh,
                   WithoutSlashes(ReadParameters<TrackingNodeParameters>(private_nh))) {}

TrackingNode::TrackingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                           const TrackingNodeParameters& parameters)
    : options_(parameters.node),
      stage_(nh, parameters.localization, parameters.publisher.base_frame, drops_),
      publisher_(nh, parameters.publisher),
      ground_truth_(nh, FrameName(options_.ground_truth_frame), parameters.publisher.map_frame),
      health_(nh, private_nh, "tracking", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      saver_(private_nh, topics::kSaveTrajectory, options_.output_directory,
             [this](const std::string& folder) { return Save(folder); }),
      worker_(std::make_unique<StageWorker<RgbdMessages>>(
          options_.queue_size, drops_,
          [this](const RgbdMessages& messages) { Process(messages); })),
      input_(std::make_unique<RgbdInput>(
          nh, parameters.input, parameters.pairer, drops_,
          [this](RgbdMessages messages) { worker_->Push(std::move(messages)); })) {
  reset_service_ = private_nh.advertiseService(topics::kReset, &TrackingNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &TrackingNode::OnPause, this);
}

TrackingNode::~TrackingNode() {
  input_.reset();
  worker_.reset();
  saver_.SaveOnShutdown();
}

void TrackingNode::Process(const RgbdMessages& messages) {
  const auto frame = stage_.Process(messages);
  if (!frame) return;
  publisher_.Publish(*frame, *stage_.localization());
  ground_truth_.Publish(frame->tracked, frame->camera_frame);
  ReportChange(Remember(*frame), frame->tracked);
  health_.AddLatency(messages.received);
}

TrackingStatus TrackingNode::Remember(const TrackedFrame& frame) {
  std::lock_guard<std::mutex> lock(mutex_);
  const TrackingStatus before = last_.status;
  last_ = frame.tracked;
  camera_frame_ = frame.camera_frame;
  if (options_.output_directory.empty()) return before;  // nothing is kept that nobody asked for
  recorder_.Add(frame.tracked);
  return before;
}

bool TrackingNode::OnReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  input_->StartOver();
  response.success = true;
  response.message = "the map is forgotten; a new one begins with the next image";
  return true;
}

bool TrackingNode::OnPause(std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  input_->SetPaused(request.data);
  response.success = true;
  response.message = request.data ? "paused: images are thrown away" : "tracking goes on";
  return true;
}

std::string TrackingNode::Save(const std::string& folder) {
  if (options_.output_directory.empty()) {
    throw InputError("nothing was recorded: start the node with ~output_directory");
  }
  const auto localization = stage_.localization();
  if (localization == nullptr) throw InputError("no image has come yet, so there is no trajectory");
  localization->Finish();
  semantic_slam::RunFacts facts;
  facts.source = "topics";
  facts.gravity = stage_.start_source();
  facts.dropped = drops_.counts();
  semantic_slam::TrajectoryRecorder recorder;
  std::string camera_frame;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    recorder = recorder_;
    camera_frame = camera_frame_;
  }
  const semantic_slam::Trajectory truth = ground_truth_.CameraPath(camera_frame);
  semantic_slam::WriteRunReport(folder, recorder, *localization, facts, truth);
  if (!truth.empty()) semantic_slam::WriteTumTrajectory(truth, folder + "/groundtruth.txt");
  return "the trajectory is in " + folder;
}

void TrackingNode::Diagnose(NodeHealth::Status& status) {
  TrackedImage last;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    last = last_;
  }
  const std::int64_t images = health_.processed();
  if (images == 0) {
    status.summary(DiagnosticStatus::WARN, "no image has been tracked yet");
  } else if (last.status == TrackingStatus::kTracking) {
    status.summary(DiagnosticStatus::OK, "tracking");
  } else {
    status.summary(DiagnosticStatus::WARN, ToString(last.status));
  }
  status.add("images", images);
  status.add("inliers", last.inliers);
  status.add("map", last.map_id);
  if (const auto localization = stage_.localization()) {
    status.add("map points", localization->map_points().size());
    status.add("keyframes rejected", localization->rejected_keyframes());
  }
}

}  // namespace semantic_slam_ros
