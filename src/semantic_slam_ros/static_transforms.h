#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <ros/time.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "semantic_slam/common/transform.h"

namespace semantic_slam_ros {

// Transforms that never change while the robot runs, such as where the camera sits on it: looked up
// once on tf and remembered. For one thread.
class StaticTransforms {
 public:
  explicit StaticTransforms(ros::NodeHandle nh) : listener_(buffer_, nh) {}

  // T_target_source; nullopt while tf does not know it, with a warning every few seconds.
  std::optional<semantic_slam::Rigid3d> Find(const std::string& target, const std::string& source);

 private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;  // has a thread of its own
  std::map<std::pair<std::string, std::string>, semantic_slam::Rigid3d> found_;
  ros::WallTime warned_;
};

}  // namespace semantic_slam_ros
