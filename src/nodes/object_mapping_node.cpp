#include "semantic_slam_ros/object_mapping_node.h"

#include "semantic_slam_ros/run_node.h"

int main(int argc, char** argv) {
  return semantic_slam_ros::RunNode<semantic_slam_ros::ObjectMappingNode>(argc, argv,
                                                                          "object_mapping");
}
