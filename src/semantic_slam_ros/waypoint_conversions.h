#pragma once

#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <semantic_slam/AttitudeThrust.h>
#include <semantic_slam/WaypointStatus.h>

#include "semantic_slam/control/waypoint_controller.h"
#include "semantic_slam_ros/conversions.h"

// What waypoint flights say and are told. Frames are given without leading slash. What reads a
// message throws semantic_slam::InputError with one line that names the fault if it is malformed.

namespace semantic_slam_ros {

// Refuses a pose that is no transform, or another frame than `frame`. The heading is the pose's x
// axis'.
semantic_slam::Waypoint ToWaypoint(const geometry_msgs::PoseStamped& msg, const std::string& frame);
// Refuses an empty path, and a frame, of the path or of a pose that names one, that is not `frame`.
std::vector<semantic_slam::Waypoint> ToWaypoints(const nav_msgs::Path& msg,
                                                 const std::string& frame);

// Refuses a pose that is no transform, and, with `use_twist`, a velocity that is not finite.
semantic_slam::BasePose ToBasePose(const nav_msgs::Odometry& msg, bool use_twist);

// `R_world_base` is the base's attitude at the header's stamp, in the command's world.
semantic_slam::AttitudeThrust ToAttitudeThrust(const semantic_slam::AttitudeCommand& command,
                                               const Eigen::Matrix3d& R_world_base,
                                               const std_msgs::Header& header);
// The same for a command whose world is the level frame at the base's heading.
semantic_slam::AttitudeThrust ToLevelThrust(const semantic_slam::AttitudeCommand& command,
                                            const std_msgs::Header& header);

// The command that a message means to a drone that had the attitude `R_world_base` at its stamp; to
// one that has it now, if the message's orientation counts from level. Refuses numbers that are not
// finite, a quaternion whose length is not 1 to 1 %, and a negative thrust.
semantic_slam::AttitudeCommand ToAttitudeCommand(const semantic_slam::AttitudeThrust& msg,
                                                 const Eigen::Matrix3d& R_world_base);

semantic_slam::WaypointStatus ToWaypointStatus(const semantic_slam::FlightStatus& status,
                                               double distance_m, bool localized,
                                               const std_msgs::Header& header);

// The way that the waypoints describe.
nav_msgs::Path ToPath(const std::vector<semantic_slam::Waypoint>& waypoints,
                      const std_msgs::Header& header);

}  // namespace semantic_slam_ros
