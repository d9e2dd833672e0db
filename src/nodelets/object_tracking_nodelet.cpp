#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/object_tracking_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using ObjectTrackingNodelet = StageNodelet<ObjectTrackingNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::ObjectTrackingNodelet, nodelet::Nodelet)
