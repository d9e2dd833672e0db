#pragma once

#include <memory>

#include <nodelet/nodelet.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

// A node class inside a nodelet manager, where messages pass without a copy. What it throws for a
// wrong parameter is told, and the manager reports that loading failed.
//
//   using TrackingNodelet = StageNodelet<TrackingNode>;
//   PLUGINLIB_EXPORT_CLASS(semantic_slam_ros::TrackingNodelet, nodelet::Nodelet)
template <typename Node>
class StageNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      node_ = std::make_unique<Node>(getNodeHandle(), getPrivateNodeHandle());
    } catch (const semantic_slam::ConfigError& e) {
      NODELET_FATAL("%s", e.what());
      throw;
    }
  }

  std::unique_ptr<Node> node_;
};

}  // namespace semantic_slam_ros
