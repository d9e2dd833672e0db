#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/object_mapping_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using ObjectMappingNodelet = StageNodelet<ObjectMappingNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::ObjectMappingNodelet, nodelet::Nodelet)
