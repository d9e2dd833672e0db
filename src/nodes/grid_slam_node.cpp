#include "semantic_slam_ros/grid_slam_node.h"

#include "semantic_slam_ros/run_node.h"

int main(int argc, char** argv) {
  return semantic_slam_ros::RunNode<semantic_slam_ros::GridSlamNode>(argc, argv, "grid_slam");
}
