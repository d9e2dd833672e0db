#include <memory>

#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/tracking_node.h"

namespace semantic_slam_ros {

// tracking_node inside a nodelet manager: images come without a copy.
class TrackingNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      node_ = std::make_unique<TrackingNode>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const semantic_slam::ConfigError& e) {
      NODELET_FATAL("%s", e.what());
      throw;  // the manager reports that loading failed
    }
  }

  std::unique_ptr<TrackingNode> node_;
};

}  // namespace semantic_slam_ros

PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::TrackingNodelet, nodelet::Nodelet)
