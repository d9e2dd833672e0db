#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/semantic_cloud_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using SemanticCloudNodelet = StageNodelet<SemanticCloudNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::SemanticCloudNodelet, nodelet::Nodelet)
