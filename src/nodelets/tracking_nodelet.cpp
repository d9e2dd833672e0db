#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/stage_nodelet.h"
#include "semantic_slam_ros/tracking_node.h"

namespace semantic_slam_ros {

using TrackingNodelet = StageNodelet<TrackingNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::TrackingNodelet, nodelet::Nodelet)
