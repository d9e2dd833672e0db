#include "semantic_slam_ros/map_saver.h"

#include <utility>

#include <ros/console.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

using semantic_slam::InputError;

MapSaver::MapSaver(ros::NodeHandle private_nh, const char* service, std::string output_directory,
                   Save save)
    : output_directory_(std::move(output_directory)), save_(std::move(save)) {
  service_ = private_nh.advertiseService(service, &MapSaver::OnSave, this);
}

void MapSaver::SaveOnShutdown() const {
  if (output_directory_.empty()) return;
  try {
    ROS_INFO("%s", save_(output_directory_).c_str());
  } catch (const InputError& e) {
    ROS_ERROR("%s", e.what());
  }
}

bool MapSaver::OnSave(semantic_slam::SaveMap::Request& request,
                      semantic_slam::SaveMap::Response& response) {
  try {
    const std::string& folder = request.path.empty() ? output_directory_ : request.path;
    if (folder.empty()) throw InputError("path is empty, and the node has no ~output_directory");
    response.message = save_(folder);
    response.success = true;
  } catch (const InputError& e) {
    response.success = false;
    response.message = e.what();
  }
  return true;
}

}  // namespace semantic_slam_ros
