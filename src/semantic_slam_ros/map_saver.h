#pragma once

#include <functional>
#include <string>

#include <ros/node_handle.h>
#include <semantic_slam/SaveMap.h>

namespace semantic_slam_ros {

// Writes what a node knows into a folder: when its SaveMap service is called, and on shutdown if it
// was given ~output_directory. For one spinning thread.
class MapSaver {
 public:
  // Writes into the folder and says in a sentence what it wrote; throws InputError if it cannot.
  using Save = std::function<std::string(const std::string& folder)>;

  // `service` is a private name. An empty path in a request means `output_directory`; with both
  // empty the request fails.
  MapSaver(ros::NodeHandle private_nh, const char* service, std::string output_directory,
           Save save);

  // For the owner's destructor, when its threads have stopped. Says on the console what became of
  // it.
  void SaveOnShutdown() const;

 private:
  bool OnSave(semantic_slam::SaveMap::Request& request, semantic_slam::SaveMap::Response& response);

  const std::string output_directory_;
  const Save save_;
  ros::ServiceServer service_;
};

}  // namespace semantic_slam_ros
