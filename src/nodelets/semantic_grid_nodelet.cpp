#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/semantic_grid_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using SemanticGridNodelet = StageNodelet<SemanticGridNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::SemanticGridNodelet, nodelet::Nodelet)
