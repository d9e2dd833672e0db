#include "semantic_slam_ros/waypoint_controller_node.h"

#include <chrono>
#include <utility>

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <ros/console.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/param_reader.h"
#include "semantic_slam_ros/topics.h"
#include "semantic_slam_ros/waypoint_conversions.h"

namespace semantic_slam_ros {

using diagnostic_msgs::DiagnosticStatus;
using semantic_slam::AttitudeCommand;
using semantic_slam::BasePose;
using semantic_slam::FlightStatus;
using semantic_slam::InputError;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;
using semantic_slam::Waypoint;

namespace {

constexpr int kQueueSize = 100;
constexpr double kJumpBackS = 1.0;

semantic_slam::Tour LoadTour(const WaypointControllerNodeOptions& options) {
  if (options.waypoints_file.empty()) return {};
  semantic_slam::Tour tour = semantic_slam::LoadTour(options.waypoints_file);
  ROS_INFO("%zu waypoints from %s", tour.waypoints.size(), options.waypoints_file.c_str());
  if (options.relative_to_first) tour.waypoints = RelativeToFirst(tour.waypoints);
  return tour;
}

// With the tour's own speed, where it has one.
semantic_slam::WaypointControllerOptions ForTour(semantic_slam::WaypointControllerOptions options,
                                                 const semantic_slam::Tour& tour) {
  options.follower.max_speed_mps = tour.max_speed_mps.value_or(options.follower.max_speed_mps);
  return options;
}

WaypointControllerNodeParameters WithoutSlashes(WaypointControllerNodeParameters parameters) {
  parameters.node.map_frame = FrameName(parameters.node.map_frame);
  return parameters;
}

}  // namespace

WaypointControllerNode::WaypointControllerNode(const ros::NodeHandle& nh,
                                               const ros::NodeHandle& private_nh)
    : WaypointControllerNode(
          nh, private_nh,
          WithoutSlashes(ReadParameters<WaypointControllerNodeParameters>(private_nh))) {}

WaypointControllerNode::WaypointControllerNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                                               const WaypointControllerNodeParameters& parameters)
    : WaypointControllerNode(nh, private_nh, parameters, LoadTour(parameters.node)) {}

WaypointControllerNode::WaypointControllerNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                                               const WaypointControllerNodeParameters& parameters,
                                               const semantic_slam::Tour& tour)
    : options_(parameters.node),
      controller_options_(ForTour(parameters.controller, tour)),
      tour_(tour.waypoints),
      joiner_(static_cast<std::size_t>(options_.max_waiting),
              static_cast<std::size_t>(options_.max_waiting)),
      command_pub_(
          nh.advertise<semantic_slam::AttitudeThrust>(topics::kAttitudeThrust, kQueueSize)),
      status_pub_(nh.advertise<semantic_slam::WaypointStatus>(topics::kWaypointStatus, 10, true)),
      path_pub_(nh.advertise<nav_msgs::Path>(topics::kReferencePath, 1, true)),
      health_(nh, private_nh, "waypoint_controller", drops_,
              [this](NodeHealth::Status& status) { Diagnose(status); }) {
  Begin(tour_);
  if (options_.use_tracking_state) {
    tracking_input_.emplace(
        nh, drops_, [this](const TrackedImage& image) { OnTracked(image); },
        GraphInput::GraphCallback());
  }
  odometry_sub_ = nh.subscribe(topics::kOdometry, kQueueSize, &WaypointControllerNode::OnOdometry,
                               this, ros::TransportHints().tcpNoDelay());
  waypoints_sub_ =
      nh.subscribe(topics::kWaypoints, kQueueSize, &WaypointControllerNode::OnWaypoints, this);
  goal_sub_ = nh.subscribe(topics::kGoal, kQueueSize, &WaypointControllerNode::OnGoal, this);
  pause_service_ =
      private_nh.advertiseService(topics::kPause, &WaypointControllerNode::OnPause, this);
  clear_service_ =
      private_nh.advertiseService(topics::kClear, &WaypointControllerNode::OnClear, this);
  reset_service_ =
      private_nh.advertiseService(topics::kReset, &WaypointControllerNode::OnReset, this);
}

void WaypointControllerNode::Begin(const std::vector<Waypoint>& waypoints) {
  controller_.emplace(controller_options_);
  controller_->follower().Replace(waypoints);
  PublishPath();
}

bool WaypointControllerNode::IsNext(Stamp stamp) {
  if (!stamp_ || stamp > *stamp_) return true;
  if (SecondsBetween(stamp, *stamp_) > kJumpBackS) {
    ROS_WARN("stamps jumped back in time: a new flight begins");
    stamp_.reset();
    map_id_.reset();
    Begin(tour_);
    return true;
  }
  drops_.AddQuietly("out_of_order");
  return false;
}

void WaypointControllerNode::OnOdometry(const nav_msgs::Odometry& msg) {
  if (!HasStamp(msg.header, "odometry", drops_)) return;
  Odometry odometry;
  try {
    odometry = {ToBasePose(msg, options_.use_odometry_twist), FrameName(msg.header.frame_id)};
  } catch (const InputError& e) {
    drops_.Add("bad_odometry", e.what());
    return;
  }
  base_frame_ = FrameName(msg.child_frame_id);
  if (options_.use_tracking_state) {
    Process(joiner_.AddSource(odometry.pose.stamp, std::move(odometry)));
  } else if (odometry.frame != options_.map_frame) {
    drops_.Add("bad_frame", "odometry is in frame '" + odometry.frame + "', expected '" +
                                options_.map_frame + "'");
  } else {
    Fly(odometry.pose);
  }
}

void WaypointControllerNode::OnTracked(const TrackedImage& image) {
  if (image.status == TrackingStatus::kTracking) {
    Process(joiner_.AddResult(image.stamp, image));
  } else {
    FlyBlind(image.stamp);
  }
}

void WaypointControllerNode::Process(std::optional<Joiner::Joined> joined) {
  const std::size_t unjoined = joiner_.unjoined_results();
  if (unjoined > counted_unjoined_) drops_.AddQuietly("no_odometry", unjoined - counted_unjoined_);
  counted_unjoined_ = unjoined;
  if (!joined) return;
  const TrackedImage& image = joined->result;
  if (map_id_ && *map_id_ != image.map_id) {
    ROS_WARN("tracking began map %d: the waypoints of the old one are forgotten", image.map_id);
    Begin({});
  }
  map_id_ = image.map_id;
  BasePose pose = joined->source.pose;
  if (joined->source.frame != options_.map_frame) {
    pose.T_map_odom = semantic_slam::MapFromOdom(image.T_map_camera, image.T_odom_camera);
  }
  Fly(pose);
}

void WaypointControllerNode::Fly(const BasePose& pose) {
  const auto received = std::chrono::steady_clock::now();
  if (!IsNext(pose.stamp)) return;
  stamp_ = pose.stamp;
  const AttitudeCommand command = controller_->Update(pose);
  command_pub_.publish(ToAttitudeThrust(command, (pose.T_map_odom * pose.T_odom_base).linear(),
                                        MakeHeader(pose.stamp, base_frame_)));
  PublishStatus(pose.stamp, true);
  health_.AddLatency(received);
}

void WaypointControllerNode::FlyBlind(Stamp stamp) {
  if (!IsNext(stamp)) return;
  stamp_ = stamp;
  drops_.AddQuietly("not_tracked");
  command_pub_.publish(ToLevelThrust(controller_->FlyBlind(stamp), MakeHeader(stamp, base_frame_)));
  PublishStatus(stamp, false);
}

void WaypointControllerNode::OnWaypoints(const nav_msgs::Path& msg) {
  try {
    controller_->follower().Replace(ToWaypoints(msg, options_.map_frame));
  } catch (const InputError& e) {
    drops_.Add("bad_waypoints", e.what());
    return;
  }
  PublishPath();
}

void WaypointControllerNode::OnGoal(const geometry_msgs::PoseStamped& msg) {
  try {
    const Waypoint goal = ToWaypoint(msg, options_.map_frame);
    if (options_.append_goals) {
      controller_->follower().Append(goal);
    } else {
      controller_->follower().Replace({goal});
    }
  } catch (const InputError& e) {
    drops_.Add("bad_waypoints", e.what());
    return;
  }
  PublishPath();
}

bool WaypointControllerNode::OnPause(std_srvs::SetBool::Request& request,
                                     std_srvs::SetBool::Response& response) {
  controller_->follower().SetPaused(request.data);
  response.success = true;
  response.message = request.data ? "paused: the drone keeps its place" : "the flight goes on";
  return true;
}

bool WaypointControllerNode::OnClear(std_srvs::Trigger::Request&,
                                     std_srvs::Trigger::Response& response) {
  controller_->follower().Clear();
  PublishPath();
  response.success = true;
  response.message = "the waypoints are forgotten; the drone keeps its place";
  return true;
}

bool WaypointControllerNode::OnReset(std_srvs::Trigger::Request&,
                                     std_srvs::Trigger::Response& response) {
  Begin(tour_);
  response.success = true;
  response.message = tour_.empty() ? "everything is forgotten; the drone keeps its place"
                                   : "the tour of ~waypoints_file begins anew";
  return true;
}

void WaypointControllerNode::PublishStatus(Stamp stamp, bool localized) {
  const double distance_m = localized ? controller_->DistanceToGo() : 0.0;
  status_pub_.publish(ToWaypointStatus(controller_->follower().status(), distance_m, localized,
                                       MakeHeader(stamp, options_.map_frame)));
}

void WaypointControllerNode::PublishPath() {
  path_pub_.publish(ToPath(controller_->follower().waypoints(),
                           MakeHeader(stamp_.value_or(Stamp()), options_.map_frame)));
}

void WaypointControllerNode::Diagnose(NodeHealth::Status& status) const {
  const FlightStatus flight = controller_->follower().status();
  if (health_.processed() == 0) {
    status.summary(DiagnosticStatus::WARN, "no odometry yet");
  } else {
    status.summary(DiagnosticStatus::OK, flight.paused ? "paused" : ToString(flight.state));
  }
  status.add("commands", health_.processed());
  status.add("waypoint", flight.index);
  status.add("waypoints", flight.count);
}

}  // namespace semantic_slam_ros
