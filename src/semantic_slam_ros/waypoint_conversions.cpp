#include "semantic_slam_ros/waypoint_conversions.h"

#include <cmath>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

using semantic_slam::AttitudeCommand;
using semantic_slam::AttitudeThrust;
using semantic_slam::FlightState;
using semantic_slam::FlightStatus;
using semantic_slam::InputError;
using semantic_slam::Waypoint;
using semantic_slam::WaypointStatus;

namespace {

void RequireFrame(const std::string& frame_id, const std::string& frame) {
  if (FrameName(frame_id) == frame) return;
  throw InputError("waypoints are in frame '" + frame_id + "', expected '" + frame + "'");
}

Eigen::Vector3d ToVector(const geometry_msgs::Vector3& msg, const char* what) {
  const Eigen::Vector3d v(msg.x, msg.y, msg.z);
  if (!v.allFinite()) throw InputError(std::string(what) + " has a number that is not finite");
  return v;
}

Waypoint ToWaypoint(const geometry_msgs::Pose& msg) {
  const Rigid3d T = ToRigid(msg);
  Waypoint waypoint;
  waypoint.position_m = T.translation();
  waypoint.yaw_rad = semantic_slam::Heading(T.linear());
  return waypoint;
}

Rigid3d PoseOf(const Waypoint& waypoint) {
  return Eigen::Translation3d(waypoint.position_m) *
         Eigen::AngleAxisd(waypoint.yaw_rad, Eigen::Vector3d::UnitZ());
}

Rigid3d Rotation(const Eigen::Matrix3d& R) {
  Rigid3d T = Rigid3d::Identity();
  T.linear() = R;
  return T;
}

std::uint8_t ToState(FlightState state) {
  switch (state) {
    case FlightState::kIdle:
      return WaypointStatus::STATE_IDLE;
    case FlightState::kFlying:
      return WaypointStatus::STATE_FLYING;
    case FlightState::kHolding:
      return WaypointStatus::STATE_HOLDING;
    case FlightState::kDone:
      return WaypointStatus::STATE_DONE;
  }
  return WaypointStatus::STATE_IDLE;
}

}  // namespace

Waypoint ToWaypoint(const geometry_msgs::PoseStamped& msg, const std::string& frame) {
  RequireFrame(msg.header.frame_id, frame);
  return ToWaypoint(msg.pose);
}

std::vector<Waypoint> ToWaypoints(const nav_msgs::Path& msg, const std::string& frame) {
  if (msg.poses.empty()) throw InputError("a path without poses");
  RequireFrame(msg.header.frame_id, frame);
  std::vector<Waypoint> waypoints;
  for (const geometry_msgs::PoseStamped& pose : msg.poses) {
    if (!pose.header.frame_id.empty()) RequireFrame(pose.header.frame_id, frame);
    waypoints.push_back(ToWaypoint(pose.pose));
  }
  return waypoints;
}

semantic_slam::BasePose ToBasePose(const nav_msgs::Odometry& msg, bool use_twist) {
  semantic_slam::BasePose pose;
  pose.stamp = ToStamp(msg.header.stamp);
  pose.T_odom_base = ToRigid(msg.pose.pose);
  if (use_twist) {
    pose.velocity_odom_mps =
        pose.T_odom_base.linear() * ToVector(msg.twist.twist.linear, "odometry's velocity");
  }
  return pose;
}

AttitudeThrust ToAttitudeThrust(const AttitudeCommand& command, const Eigen::Matrix3d& R_world_base,
                                const std_msgs::Header& header) {
  AttitudeThrust msg;
  msg.header = header;
  msg.orientation =
      ToPose(Rotation(R_world_base.transpose() * command.R_world_desired)).orientation;
  const Eigen::Vector3d& rates = command.angular_velocity_radps;
  msg.angular_velocity.x = rates.x();
  msg.angular_velocity.y = rates.y();
  msg.angular_velocity.z = rates.z();
  msg.thrust = command.thrust_n;
  return msg;
}

AttitudeThrust ToLevelThrust(const AttitudeCommand& command, const std_msgs::Header& header) {
  AttitudeThrust msg = ToAttitudeThrust(command, Eigen::Matrix3d::Identity(), header);
  msg.level = true;
  return msg;
}

AttitudeCommand ToAttitudeCommand(const AttitudeThrust& msg, const Eigen::Matrix3d& R_world_base) {
  if (!(msg.thrust >= 0.0 && std::isfinite(msg.thrust))) {
    throw InputError("thrust is " + std::to_string(msg.thrust) + " N, expected 0 or more");
  }
  geometry_msgs::Pose turn;
  turn.orientation = msg.orientation;
  const Eigen::Matrix3d R_world_from =
      msg.level ? semantic_slam::LevelAttitude(R_world_base) : R_world_base;
  AttitudeCommand command;
  command.R_world_desired = R_world_from * ToRigid(turn).linear();
  command.angular_velocity_radps = ToVector(msg.angular_velocity, "the desired angular velocity");
  command.thrust_n = msg.thrust;
  return command;
}

WaypointStatus ToWaypointStatus(const FlightStatus& status, double distance_m, bool localized,
                                const std_msgs::Header& header) {
  WaypointStatus msg;
  msg.header = header;
  msg.state = ToState(status.state);
  msg.paused = status.paused;
  msg.localized = localized;
  msg.index = static_cast<std::uint32_t>(status.index);
  msg.count = static_cast<std::uint32_t>(status.count);
  msg.distance = distance_m;
  return msg;
}

nav_msgs::Path ToPath(const std::vector<Waypoint>& waypoints, const std_msgs::Header& header) {
  nav_msgs::Path msg;
  msg.header = header;
  for (const Waypoint& waypoint : waypoints) {
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose = ToPose(PoseOf(waypoint));
    msg.poses.push_back(pose);
  }
  return msg;
}

}  // namespace semantic_slam_ros
