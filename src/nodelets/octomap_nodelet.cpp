#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/octomap_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using OctomapNodelet = StageNodelet<OctomapNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::OctomapNodelet, nodelet::Nodelet)
