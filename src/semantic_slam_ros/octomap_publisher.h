#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/map_projection.h"
#include "semantic_slam/octree/semantic_map.h"
#include "semantic_slam/octree/voxel_colours.h"
#include "semantic_slam_ros/octree_conversions.h"

namespace semantic_slam_ros {

struct OctomapPublisherOptions {
  std::string map_frame = "map";
  std::string colour_mode = "class";   // class, rgb or height
  double low_z_m = 0.0;                // with height: blue at and below
  double high_z_m = 2.5;               // with height: red at and above
  double markers_max_z_m = 1000.0;     // cells above are not shown: look below the ceiling
  double projected_min_z_m = -1000.0;  // of what the projected map shows
  double projected_max_z_m = 1000.0;
  std::string projected_left_out = "floor,ceiling";  // classes: in nobody's way
  double publish_period_s = 1.0;  // between two publications of the map, of the wall's clock

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("map_frame", self.map_frame);
    visit("colour_mode", self.colour_mode);
    visit("low_z_m", self.low_z_m, -1000.0, 1000.0);
    visit("high_z_m", self.high_z_m, -1000.0, 1000.0);
    visit("markers_max_z_m", self.markers_max_z_m, -1000.0, 1000.0);
    visit("projected_min_z_m", self.projected_min_z_m, -1000.0, 1000.0);
    visit("projected_max_z_m", self.projected_max_z_m, -1000.0, 1000.0);
    visit("projected_left_out", self.projected_left_out);
    visit("publish_period_s", self.publish_period_s, 0.05, 3600.0);
  }
};

// Publishes a semantic map, in whole, to those who subscribe: when it has changed, or when somebody
// new has come. For one thread.
class OctomapPublisher {
 public:
  // Throws ConfigError if an option is wrong. `vocabulary` must outlive this.
  OctomapPublisher(ros::NodeHandle nh, const OctomapPublisherOptions& options,
                   const semantic_slam::LabelVocabulary& vocabulary);

  // Whether there is somebody who has not seen a map of that version.
  bool IsDue(std::uint64_t version) const;

  // Publishing in two steps, so that who guards the map need not guard it while messages go out.
  void Collect(const semantic_slam::SemanticMapper& mapper);
  void Send();

 private:
  const OctomapPublisherOptions options_;
  const semantic_slam::LabelVocabulary& vocabulary_;
  const semantic_slam::VoxelColours colours_;
  std::atomic<bool> somebody_came_{false};  // set by ROS' threads
  std::uint64_t sent_version_ = 0;
  const semantic_slam::MapProjectionOptions projection_;
  OccupiedCells cells_;
  semantic_slam::ProjectedMap projected_;
  std_msgs::Header header_;
  std::vector<semantic_slam::LabelId> legend_;  // classes in the legend sent last
  ros::Publisher labels_pub_;
  ros::Publisher markers_pub_;
  ros::Publisher cells_pub_;
  ros::Publisher legend_pub_;
  ros::Publisher projected_pub_;
};

}  // namespace semantic_slam_ros
