#include "semantic_slam_ros/simulator_node.h"

#include <algorithm>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>
#include <ros/init.h>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/world_file.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/simulator_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::InputError;
using semantic_slam::RelativeAttitudeCommand;
using semantic_slam::RenderedView;
using semantic_slam::SecondsBetween;
using semantic_slam::SimulatedFlight;
using semantic_slam::SimulatedImage;
using semantic_slam::World;
using SteadyClock = std::chrono::steady_clock;

namespace {

constexpr int kQueueSize = 100;
// Late enough that nobody who looks back for a while falls off the beginning of time.
constexpr semantic_slam::Stamp kStart{100'000'000'000};
// Of readings before the first image: they tell tracking which way is up.
constexpr double kWarmUpS = 0.6;
constexpr double kListenerPeriodS = 0.1;

}  // namespace

SimulatorNode::SimulatorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
    : SimulatorNode(nh, private_nh, ReadParameters<SimulatorNodeParameters>(private_nh)) {}

SimulatorNode::SimulatorNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                             const SimulatorNodeParameters& parameters)
    : parameters_(parameters),
      is_controlled_(IsControlled(private_nh, parameters.node)),
      vocabulary_(LoadLabels(private_nh, parameters.labels)),
      tour_(LoadTourIfNamed(parameters.node)),
      T_world_start_(FlightStart(parameters.node, tour_)),
      world_(std::make_shared<const World>(semantic_slam::LoadWorld(
          RequiredFile(private_nh, "world", parameters.node.world), vocabulary_))),
      camera_(std::make_shared<const semantic_slam::SceneRenderer>(world_),
              semantic_slam::LoadCameraConfig(
                  RequiredFile(private_nh, "camera", parameters.node.camera))
                  .intrinsics,
              parameters.camera),
      visible_boxes_(parameters.visible_boxes, world_, vocabulary_),
      label_errors_(parameters.label_errors, vocabulary_),
      box_errors_(parameters.box_errors, vocabulary_),
      publisher_(nh, parameters.frames, parameters.flight, vocabulary_,
                 camera_.model().intrinsics()),
      pace_(parameters.node.rate),
      lockstep_(parameters.lockstep, is_controlled_),
      flight_(MakeFlight()),
      labels_throttle_(parameters.node.labels_period_s),
      detections_throttle_(parameters.node.detections_period_s),
      health_(nh, private_nh, "simulator", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }),
      loop_(1, semantic_slam::WhenFull::kReject, [this](Tick) { Work(); }) {
  command_sub_ = nh.subscribe(topics::kAttitudeThrust, kQueueSize, &SimulatorNode::OnCommand, this);
  tracking_sub_ = nh.subscribe(topics::kTrackingState, kQueueSize, &SimulatorNode::OnTracked, this);
  status_sub_ =
      nh.subscribe(topics::kWaypointStatus, kQueueSize, &SimulatorNode::OnWaypointStatus, this);
  reset_service_ = private_nh.advertiseService(topics::kReset, &SimulatorNode::OnReset, this);
  pause_service_ = private_nh.advertiseService(topics::kPause, &SimulatorNode::OnPause, this);
  loop_.Push({});
}

std::unique_ptr<SimulatedFlight> SimulatorNode::MakeFlight() const {
  return std::make_unique<SimulatedFlight>(FlightOptionsFor(tour_, parameters_.flight),
                                           T_world_start_, kStart);
}

SimulatorNode::~SimulatorNode() {
  pace_.Stop();
  lockstep_.Close();
}

// One image, and on to the next. A parameter that is wrong has stopped the node in its constructor,
// so nothing here throws.
void SimulatorNode::Work() {
  if (wants_reset_.exchange(false)) Restart();
  if (!is_prepared_ && !Prepare()) return;
  ShowImage();
  lockstep_.AwaitAnswers(flight_->stamp());
  Steer();
  publisher_.PublishReadings(flight_->FlyToNextImage());
  if (IsOver()) {
    ROS_INFO("the flight is over at %s s", ToString(flight_->stamp()).c_str());
    ros::requestShutdown();
  } else if (pace_.AwaitDue(flight_->stamp())) {
    loop_.Push({});
  }
}

// Waits for those who must not miss the first image, and hovers until the imu has told them which
// way is up. False if the node ends.
bool SimulatorNode::Prepare() {
  const auto start = SteadyClock::now();
  const auto limit = std::chrono::duration<double>(parameters_.lockstep.start_limit_s);
  while (parameters_.lockstep.lockstep && SteadyClock::now() - start < limit &&
         !(publisher_.has_listener() && tracking_sub_.getNumPublishers() > 0 &&
           (!is_controlled_ || command_sub_.getNumPublishers() > 0))) {
    publisher_.PublishClock(flight_->stamp());
    if (!pace_.AwaitSeconds(kListenerPeriodS)) return false;
  }
  while (SecondsBetween(kStart, flight_->stamp()) < kWarmUpS) {
    publisher_.PublishClock(flight_->stamp());
    publisher_.PublishCameraInfo(flight_->stamp());
    publisher_.PublishReadings(flight_->FlyToNextImage());
    if (!pace_.AwaitDue(flight_->stamp())) return false;
  }
  is_prepared_ = true;
  return true;
}

// Time goes back: who follows forgets what was before.
void SimulatorNode::Restart() {
  ROS_WARN("back to the start: the drone, the people and the time");
  flight_ = MakeFlight();
  lockstep_.Restart();
  is_prepared_ = is_under_way_ = false;
  is_way_done_ = false;
  done_.reset();
  std::lock_guard<std::mutex> lock(mutex_);
  commands_.clear();
}

void SimulatorNode::ShowImage() {
  const auto start = SteadyClock::now();
  const Stamp stamp = flight_->stamp();
  publisher_.PublishClock(stamp);
  publisher_.PublishTruth(*flight_);
  const SimulatedImage image = camera_.Capture(flight_->T_world_camera(), stamp, WorldTime(stamp));
  publisher_.PublishImages(image.measured);
  health_.AddLatency(start);
  ShowNetworks(image, stamp);
  std::lock_guard<std::mutex> lock(mutex_);
  ++progress_.images;
  progress_.stamp = stamp;
}

void SimulatorNode::ShowNetworks(const SimulatedImage& image, Stamp stamp) {
  const RenderedView& truth = image.truth;
  if (parameters_.node.publish_labels && publisher_.wants_segmentation() &&
      labels_throttle_.IsDue(stamp)) {
    publisher_.PublishSegmentation(label_errors_.Apply(truth.labels, truth.instances, stamp),
                                   image.measured);
  }
  if (parameters_.node.publish_detections && publisher_.wants_detections() &&
      detections_throttle_.IsDue(stamp)) {
    const auto visible = visible_boxes_.Find(truth, flight_->T_world_camera(), camera_.model(),
                                             WorldTime(stamp), stamp);
    publisher_.PublishDetections(box_errors_.Apply(visible.detections), image.measured);
  }
}

double SimulatorNode::WorldTime(Stamp stamp) const {
  return SecondsBetween(kStart, stamp);
}

// The drone stays where it is until those who follow it have begun to.
void SimulatorNode::Steer() {
  std::vector<RelativeAttitudeCommand> commands;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    commands.swap(commands_);
  }
  if (!lockstep_.began()) return;
  if (!is_under_way_ && !is_controlled_) flight_->FlyTour(tour_.waypoints);
  is_under_way_ = true;
  for (const RelativeAttitudeCommand& command : commands) {
    try {
      flight_->Follow(command);
    } catch (const InputError& e) {
      drops_.Add("bad_command", e.what());
    }
  }
}

bool SimulatorNode::IsOver() {
  const SimulatorNodeOptions& options = parameters_.node;
  const Stamp now = flight_->stamp();
  if (options.duration_s > 0.0 && SecondsBetween(kStart, now) >= options.duration_s) return true;
  const bool is_done = is_controlled_ ? is_way_done_.load() : flight_->IsTourDone();
  if (!is_done) done_.reset();
  if (is_done && !done_) done_ = now;
  return options.exit_when_done && done_ && SecondsBetween(*done_, now) >= options.exit_delay_s;
}

void SimulatorNode::OnCommand(const semantic_slam::AttitudeThrustConstPtr& msg) try {
  if (!is_controlled_) throw InputError("attitude_thrust came, but the drone flies a tour");
  const RelativeAttitudeCommand command = ToRelativeAttitudeCommand(*msg);
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (commands_.size() < kQueueSize) commands_.push_back(command);
  }
  lockstep_.NoteCommanded(command.stamp);
} catch (const InputError& e) {
  drops_.Add("bad_command", e.what());
}

void SimulatorNode::OnTracked(const semantic_slam::TrackingStateConstPtr& msg) {
  lockstep_.NoteTracked(ToStamp(msg->header.stamp),
                        msg->state == semantic_slam::TrackingState::STATE_TRACKING);
}

void SimulatorNode::OnWaypointStatus(const semantic_slam::WaypointStatusConstPtr& msg) {
  is_way_done_ = msg->state == semantic_slam::WaypointStatus::STATE_DONE;
}

bool SimulatorNode::OnReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  wants_reset_ = true;
  response.success = true;
  response.message = "the flight begins anew with the next image";
  return true;
}

bool SimulatorNode::OnPause(std_srvs::SetBool::Request& request,
                            std_srvs::SetBool::Response& response) {
  is_paused_ = request.data != 0;
  pace_.SetPaused(is_paused_);
  response.success = true;
  response.message = is_paused_ ? "time stands still" : "time goes on";
  return true;
}

void SimulatorNode::Diagnose(NodeHealth::Status& status) {
  Progress progress;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    progress = progress_;
  }
  if (is_paused_) {
    status.summary(DiagnosticStatus::OK, "paused");
  } else if (!lockstep_.began()) {
    status.summary(DiagnosticStatus::WARN, "waiting for tracking and control to answer");
  } else {
    status.summary(DiagnosticStatus::OK, "simulating");
  }
  status.add("images", progress.images);
  status.add("time [s]", ToString(progress.stamp));
  status.addf("images per second", "%.1f", ImagesPerSecond(progress));
  status.add("waits for tracking that ran out", lockstep_.late_tracking());
  status.add("waits for control that ran out", lockstep_.late_control());
}

// Since the last call.
double SimulatorNode::ImagesPerSecond(const Progress& progress) {
  const auto now = SteadyClock::now();
  const std::chrono::duration<double> passed = now - diagnosed_at_;
  const std::int64_t images = progress.images - diagnosed_.images;
  diagnosed_ = progress;
  diagnosed_at_ = now;
  return static_cast<double>(images) / passed.count();
}

}  // namespace semantic_slam_ros
