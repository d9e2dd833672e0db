#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/grid_slam_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using GridSlamNodelet = StageNodelet<GridSlamNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::GridSlamNodelet, nodelet::Nodelet)
