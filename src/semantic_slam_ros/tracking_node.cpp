#include "semantic_slam_ros/tracking_node.h"

#include <cmath>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include "semantic_slam/common/check.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/localization/run_report.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;

namespace {

constexpr char kLate[] = "late";

void ReportChange(TrackingStatus before, const TrackedImage& now) {
  if (before == now.status) return;
  const std::string stamp = ToString(now.stamp);
  if (now.status == TrackingStatus::kLost) ROS_WARN("lost at %s s", stamp.c_str());
  if (now.status == TrackingStatus::kTracking) ROS_INFO("tracking from %s s", stamp.c_str());
}

}  // namespace

TrackingNodeParameters ReadTrackingNodeParameters(const ros::NodeHandle& private_nh) {
  TrackingNodeParameters parameters;
  ParamReader reader(private_nh);
  reader.Read(parameters.node);
  reader.Read(parameters.input);
  reader.Read(parameters.publisher);
  reader.ReadGroup("pairer", parameters.pairer);
  semantic_slam::LocalizationOptions::VisitGroups(
      parameters.localization,
      [&](const char* name, auto& group) { reader.ReadGroup(name, group); });
  reader.Finish();
  parameters.publisher.map_frame = FrameName(parameters.publisher.map_frame);
  parameters.publisher.odom_frame = FrameName(parameters.publisher.odom_frame);
  parameters.publisher.base_frame = FrameName(parameters.publisher.base_frame);
  return parameters;
}

TrackingNode::TrackingNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : TrackingNode(nh, private_nh, ReadTrackingNodeParameters(private_nh)) {}

TrackingNode::TrackingNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                           const TrackingNodeParameters& parameters)
    : options_(parameters.node),
      stage_(nh, parameters.localization, parameters.publisher.base_frame, drops_),
      publisher_(nh, parameters.publisher),
      ground_truth_(nh, FrameName(options_.ground_truth_frame), parameters.publisher.map_frame),
      diagnostics_(nh, private_nh),
      worker_(std::make_unique<semantic_slam::Worker<RgbdMessages>>(
          options_.queue_size, semantic_slam::WhenFull::kDropOldest,
          [this](const RgbdMessages& messages) { Process(messages); })),
      input_(std::make_unique<RgbdInput>(
          nh, parameters.input, parameters.pairer, drops_,
          [this](RgbdMessages messages) { worker_->Push(std::move(messages)); })) {
  reset_service_ = private_nh.advertiseService(topics::kReset, &TrackingNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &TrackingNode::OnPause, this);
  save_service_ = private_nh.advertiseService(topics::kSaveTrajectory, &TrackingNode::OnSave, this);
  diagnostics_.setHardwareID("none");
  diagnostics_.add("tracking", this, &TrackingNode::Diagnose);
  const double period_s = diagnostics_.getPeriod();
  semantic_slam::CheckInRange(private_nh.resolveName("diagnostic_period"), period_s, 0.1, 60.0);
  // By the wall's clock, and forced: update() waits for the simulated one, which may stand or jump.
  diagnostics_timer_ =
      nh.createWallTimer(ros::WallDuration(period_s),
                         [this](const ros::WallTimerEvent&) { diagnostics_.force_update(); });
}

TrackingNode::~TrackingNode() {
  input_.reset();
  const std::size_t late = worker_->dropped();
  worker_.reset();
  if (late > 0) drops_.AddQuietly(kLate, late);
  if (options_.output_directory.empty()) return;
  try {
    Save(options_.output_directory);
    ROS_INFO("results are in %s", options_.output_directory.c_str());
  } catch (const InputError& e) {
    ROS_ERROR("%s", e.what());
  }
}

void TrackingNode::Process(const RgbdMessages& messages) {
  const auto frame = stage_.Process(messages);
  if (!frame) return;
  publisher_.Publish(*frame, *stage_.localization());
  ground_truth_.Publish(frame->tracked, frame->camera_frame);
  const std::chrono::duration<double, std::milli> latency =
      std::chrono::steady_clock::now() - messages.received;
  ReportChange(Remember(*frame, latency.count()), frame->tracked);
}

TrackingStatus TrackingNode::Remember(const TrackedFrame& frame, double latency_ms) {
  std::lock_guard<std::mutex> lock(mutex_);
  const TrackingStatus before = health_.last.status;
  health_.last = frame.tracked;
  health_.latency.Add(latency_ms);
  health_.camera_frame = frame.camera_frame;
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

bool TrackingNode::OnSave(semantic_slam::SaveMap::Request& request,
                          semantic_slam::SaveMap::Response& response) {
  try {
    if (options_.output_directory.empty()) {
      throw InputError("nothing was recorded: start the node with ~output_directory");
    }
    const std::string folder = request.path.empty() ? options_.output_directory : request.path;
    Save(folder);
    response.success = true;
    response.message = "the trajectory was written to " + folder;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

void TrackingNode::Save(const std::string& folder) {
  const auto localization = stage_.localization();
  if (localization == nullptr) throw InputError("no image has come yet, so there is no trajectory");
  localization->Finish();
  semantic_slam::RunFacts facts;
  facts.source = "topics";
  facts.gravity = stage_.start_source();
  facts.dropped = Drops();
  semantic_slam::TrajectoryRecorder recorder;
  std::string camera_frame;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    recorder = recorder_;
    camera_frame = health_.camera_frame;
  }
  semantic_slam::WriteRunReport(folder, recorder, *localization, facts,
                                ground_truth_.CameraPath(camera_frame));
}

std::map<std::string, std::size_t> TrackingNode::Drops() const {
  std::map<std::string, std::size_t> drops = drops_.counts();
  if (worker_ != nullptr && worker_->dropped() > 0) drops[kLate] = worker_->dropped();
  return drops;
}

void TrackingNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  Health health;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    health = health_;
  }
  const std::int64_t images = health.latency.count();
  if (images == 0) {
    status.summary(DiagnosticStatus::WARN, "no image has been tracked yet");
  } else if (health.last.status == TrackingStatus::kTracking) {
    status.summary(DiagnosticStatus::OK, "tracking");
  } else {
    status.summary(DiagnosticStatus::WARN, ToString(health.last.status));
  }
  status.add("images", images);
  status.add("inliers", health.last.inliers);
  status.add("map", health.last.map_id);
  status.addf("latency median [ms]", "%.1f", health.latency.QuantileMs(0.5));
  status.addf("latency 95 % [ms]", "%.1f", health.latency.QuantileMs(0.95));
  if (const auto localization = stage_.localization()) {
    status.add("map points", localization->map_points().size());
    status.add("keyframes rejected", localization->rejected_keyframes());
  }
  for (const auto& [cause, count] : Drops()) status.add("dropped: " + cause, count);
}

}  // namespace semantic_slam_ros
