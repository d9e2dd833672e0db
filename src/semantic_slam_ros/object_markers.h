#pragma once

#include <set>
#include <string>

#include <visualization_msgs/MarkerArray.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"

namespace semantic_slam_ros {

// Draws the object map for rviz: for each object its oriented box, its footprint on the floor plan
// at its lowest point, and its class with probability above it. Remembers what it drew, so that
// objects that are gone are taken away. Not thread-safe.
class ObjectMarkers {
 public:
  visualization_msgs::MarkerArray Draw(const semantic_slam::ObjectMap& map,
                                       const semantic_slam::LabelVocabulary& vocabulary,
                                       const std::string& map_frame);

 private:
  std::set<semantic_slam::ObjectId> drawn_;
};

}  // namespace semantic_slam_ros
