#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/stage_nodelet.h"
#include "semantic_slam_ros/waypoint_controller_node.h"

namespace semantic_slam_ros {

using WaypointControllerNodelet = StageNodelet<WaypointControllerNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::WaypointControllerNodelet, nodelet::Nodelet)
