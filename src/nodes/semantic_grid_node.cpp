#include "semantic_slam_ros/semantic_grid_node.h"

#include "semantic_slam_ros/run_node.h"

int main(int argc, char** argv) {
  return semantic_slam_ros::RunNode<semantic_slam_ros::SemanticGridNode>(argc, argv,
                                                                         "semantic_grid");
}
