#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam_ros/simulator_node.h"
#include "semantic_slam_ros/stage_nodelet.h"

namespace semantic_slam_ros {

using SimulatorNodelet = StageNodelet<SimulatorNode>;

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::SimulatorNodelet, nodelet::Nodelet)
