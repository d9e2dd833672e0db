#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/detection_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using DetectionNodelet = StageNodelet<DetectionNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::DetectionNodelet, nodelet::Nodelet)
