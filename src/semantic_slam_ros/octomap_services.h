#pragma once

#include <functional>
#include <mutex>
#include <string>

#include <ros/node_handle.h>
#include <semantic_slam/ClearBox.h>
#include <semantic_slam/LoadMap.h>
#include <semantic_slam/QueryMap.h>

#include "semantic_slam/octree/semantic_map.h"

namespace semantic_slam_ros {

// What octomap_node is asked while it maps: ~query, ~load_map and ~clear_box. For one spinning
// thread.
class OctomapServices {
 public:
  // All must outlive this. `mutex` guards `mapper`; `on_load` is called before another map is put
  // in its place, with the mutex free.
  OctomapServices(ros::NodeHandle private_nh, std::string map_frame, std::mutex& mutex,
                  semantic_slam::SemanticMapper& mapper, std::function<void()> on_load);

 private:
  bool OnQuery(semantic_slam::QueryMap::Request& request,
               semantic_slam::QueryMap::Response& response);
  bool OnLoad(semantic_slam::LoadMap::Request& request, semantic_slam::LoadMap::Response& response);
  bool OnClearBox(semantic_slam::ClearBox::Request& request,
                  semantic_slam::ClearBox::Response& response);

  const std::string map_frame_;
  std::mutex& mutex_;
  semantic_slam::SemanticMapper& mapper_;
  const std::function<void()> on_load_;
  ros::ServiceServer query_service_;
  ros::ServiceServer load_service_;
  ros::ServiceServer clear_service_;
};

}  // namespace semantic_slam_ros
