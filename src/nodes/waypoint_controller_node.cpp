#include "semantic_slam_ros/waypoint_controller_node.h"

#include "semantic_slam_ros/run_node.h"

int main(int argc, char** argv) {
  return semantic_slam_ros::RunNode<semantic_slam_ros::WaypointControllerNode>(
      argc, argv, "waypoint_controller");
}
