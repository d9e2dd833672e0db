#include "semantic_slam_ros/tracking_node.h"

#include "semantic_slam/common/heap.h"
#include "semantic_slam_ros/run_node.h"

int main(int argc, char** argv) {
  semantic_slam::ReturnLargeBlocks();
  return semantic_slam_ros::RunNode<semantic_slam_ros::TrackingNode>(argc, argv, "tracking");
}
