#pragma once

#include <cstdlib>

#include <ros/ros.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

// The whole of main(): builds a Node from its two node handles and spins until Ctrl-C. Returns the
// exit status, failure with one line on the console if a parameter or a file it names is wrong.
template <typename Node>
int RunNode(int argc, char** argv, const char* name) {
  ros::init(argc, argv, name);
  // Outside the try, so they outlive the node: when the last handle dies ROS stops logging, and
  // what went wrong would be lost.
  const ros::NodeHandle nh;
  const ros::NodeHandle private_nh("~");
  try {
    Node node(nh, private_nh);
    ros::spin();
  } catch (const semantic_slam::ConfigError& e) {
    ROS_FATAL("%s", e.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace semantic_slam_ros
