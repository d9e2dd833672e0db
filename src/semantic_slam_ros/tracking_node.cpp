#include "semantic_slam_ros/tracking_node.h"

#include <filesystem>
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

constexpr char kMapFile[] = "localization.map";  // in the folder that SaveMap names

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
      stage_(nh, parameters.localization, parameters.map, parameters.labels,
             parameters.publisher.base_frame, drops_),
      publisher_(nh, parameters.publisher),
      ground_truth_(nh, FrameName(options_.ground_truth_frame), parameters.publisher.map_frame),
      health_(nh, private_nh, "tracking", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      saver_(private_nh, topics::kSaveTrajectory, options_.output_directory,
             [this](const std::string& folder) { return Save(folder); }),
      map_saver_(private_nh, topics::kSaveMap, options_.output_directory,
                 [this](const std::string& folder) { return SaveMap(folder); }),
      worker_(std::make_unique<StageWorker<RgbdMessages>>(
          options_.queue_size, drops_,
          [this](const RgbdMessages& messages) { Process(messages); })),
      input_(std::make_unique<RgbdInput>(
          nh, parameters.input, parameters.pairer, drops_,
          [this](RgbdMessages messages) { worker_->Push(std::move(messages)); })) {
  reset_service_ = private_nh.advertiseService(topics::kReset, &TrackingNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &TrackingNode::OnPause, this);
  load_map_service_ = private_nh.advertiseService(topics::kLoadMap, &TrackingNode::OnLoadMap, this);
  set_mapping_service_ =
      private_nh.advertiseService(topics::kSetMapping, &TrackingNode::OnSetMapping, this);
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
  response.message = stage_.is_mapping()
                         ? "the map is forgotten; a new one begins with the next image"
                         : "mapping is off: the map stays, and the camera's place is looked for";
  return true;
}

bool TrackingNode::OnPause(std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  input_->SetPaused(request.data);
  response.success = true;
  response.message = request.data ? "paused: images are thrown away" : "tracking goes on";
  return true;
}

bool TrackingNode::OnSetMapping(std_srvs::SetBool::Request& request,
                                std_srvs::SetBool::Response& response) {
  stage_.SetMapping(request.data);
  response.success = true;
  response.message = request.data ? "the map grows" : "the map stays as it is";
  return true;
}

bool TrackingNode::OnLoadMap(semantic_slam::LoadMap::Request& request,
                             semantic_slam::LoadMap::Response& response) {
  try {
    response.message = LoadMap(request.path.empty() ? options_.output_directory : request.path);
    response.success = true;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

std::shared_ptr<semantic_slam::VisualLocalization> TrackingNode::RunningLocalization() const {
  auto localization = stage_.localization();
  if (localization == nullptr) throw InputError("no image has come yet, so there is no map");
  return localization;
}

std::string TrackingNode::SaveMap(const std::string& folder) const {
  const std::string path = (std::filesystem::path(folder) / kMapFile).string();
  RunningLocalization()->SaveMap(path);
  return "the map is in " + path;
}

// `path` is a map's file, or the folder that one was saved into.
std::string TrackingNode::LoadMap(const std::string& path) const {
  if (path.empty()) throw InputError("path is empty, and the node has no ~output_directory");
  std::error_code error;  // what cannot be looked at cannot be read either
  const std::string file = std::filesystem::is_directory(path, error)
                               ? (std::filesystem::path(path) / kMapFile).string()
                               : path;
  RunningLocalization()->LoadMap(file);
  return "the map of " + file + " is loaded; the camera's place in it is looked for";
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
  status.add("mapping", stage_.is_mapping());
  if (const auto localization = stage_.localization()) {
    status.add("map points", localization->map_points().size());
    status.add("keyframes rejected", localization->rejected_keyframes());
  }
}

}  // namespace semantic_slam_ros
