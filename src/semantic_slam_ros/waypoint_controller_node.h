#pragma once

#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/stamp_joiner.h"
#include "semantic_slam/control/waypoint_controller.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/graph_input.h"
#include "semantic_slam_ros/node_health.h"

namespace semantic_slam_ros {

struct WaypointControllerNodeOptions {
  std::string waypoints_file;       // the tour that is flown from the start; empty: none
  bool relative_to_first = true;    // the map begins at the file's first waypoint
  std::string map_frame = "map";    // the waypoints' frame
  bool use_tracking_state = true;   // it tells where the odometry's frame is in the map
  bool use_odometry_twist = false;  // believe the odometry's velocity; else it is estimated
  bool append_goals = true;         // a goal is flown to after the others; else instead of them
  int max_waiting = 30;             // odometry and tracking states that wait for each other

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("waypoints_file", self.waypoints_file);
    visit("relative_to_first", self.relative_to_first);
    visit("map_frame", self.map_frame);
    visit("use_tracking_state", self.use_tracking_state);
    visit("use_odometry_twist", self.use_odometry_twist);
    visit("append_goals", self.append_goals);
    visit("max_waiting", self.max_waiting, 1, 1000);
  }
};

// Everything that waypoint_controller_node reads from its private parameters.
struct WaypointControllerNodeParameters {
  WaypointControllerNodeOptions node;
  semantic_slam::WaypointControllerOptions controller;

  template <typename Self, typename Visitor>
  static void VisitGroups(Self& self, Visitor&& visit) {
    visit("", self.node);
    semantic_slam::WaypointControllerOptions::VisitGroups(self.controller, visit);
  }
};

// Wires WaypointController to topics; docs/ros_api.md lists them. Everything happens in the
// callbacks, on one spinning thread: a command takes some microseconds.
class WaypointControllerNode {
 public:
  // Throws ConfigError if a parameter or a file that it names is wrong.
  WaypointControllerNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  // Odometry as it came.
  struct Odometry {
    semantic_slam::BasePose pose;
    std::string frame;
  };
  using Joiner = semantic_slam::StampJoiner<Odometry, semantic_slam::TrackedImage>;

  WaypointControllerNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                         const WaypointControllerNodeParameters& parameters);
  WaypointControllerNode(ros::NodeHandle nh, ros::NodeHandle private_nh,
                         const WaypointControllerNodeParameters& parameters,
                         const semantic_slam::Tour& tour);

  void OnOdometry(const nav_msgs::Odometry& msg);
  void OnTracked(const semantic_slam::TrackedImage& image);
  void OnWaypoints(const nav_msgs::Path& msg);
  void OnGoal(const geometry_msgs::PoseStamped& msg);
  bool OnPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool OnClear(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool OnReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  // A new controller; the waypoints are flown to, and nothing of before is remembered.
  void Begin(const std::vector<semantic_slam::Waypoint>& waypoints);
  // False, and counted, if the stamp is not later than those before. Stamps that jump back by over
  // a second begin a new flight.
  bool IsNext(semantic_slam::Stamp stamp);
  void Process(std::optional<Joiner::Joined> joined);
  void Fly(const semantic_slam::BasePose& pose);
  void FlyBlind(semantic_slam::Stamp stamp);
  void PublishStatus(semantic_slam::Stamp stamp, bool localized);
  void PublishPath();
  void Diagnose(NodeHealth::Status& status) const;

  const WaypointControllerNodeOptions options_;
  const semantic_slam::WaypointControllerOptions controller_options_;
  const std::vector<semantic_slam::Waypoint> tour_;
  DropCounter drops_;
  Joiner joiner_;
  std::size_t counted_unjoined_ = 0;  // what of the joiner's losses is in drops_ already
  std::optional<semantic_slam::WaypointController> controller_;  // set from the constructor on
  std::optional<semantic_slam::Stamp> stamp_;                    // of the last command
  std::optional<int> map_id_;
  std::string base_frame_;  // empty before the first odometry
  ros::Publisher command_pub_;
  ros::Publisher status_pub_;
  ros::Publisher path_pub_;
  NodeHealth health_;
  // Last, so that no callback finds a member gone.
  std::optional<GraphInput> tracking_input_;
  ros::Subscriber odometry_sub_;
  ros::Subscriber waypoints_sub_;
  ros::Subscriber goal_sub_;
  ros::ServiceServer pause_service_;
  ros::ServiceServer clear_service_;
  ros::ServiceServer reset_service_;
};

}  // namespace semantic_slam_ros
