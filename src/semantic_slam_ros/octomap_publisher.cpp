#include "semantic_slam_ros/octomap_publisher.h"

#include <utility>

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/network_parameters.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::ColourModeFromName;
using semantic_slam::ConfigError;

namespace {

OctomapPublisherOptions Checked(OctomapPublisherOptions options) {
  options.map_frame = FrameName(options.map_frame);
  if (options.map_frame.empty()) throw ConfigError("~map_frame is empty");
  if (options.low_z_m >= options.high_z_m) {
    throw ConfigError("~low_z_m = " + std::to_string(options.low_z_m) +
                      ", but must be below ~high_z_m = " + std::to_string(options.high_z_m));
  }
  if (options.projected_min_z_m >= options.projected_max_z_m) {
    throw ConfigError(
        "~projected_min_z_m = " + std::to_string(options.projected_min_z_m) +
        ", but must be below ~projected_max_z_m = " + std::to_string(options.projected_max_z_m));
  }
  return options;
}

semantic_slam::MapProjectionOptions ProjectionOf(const OctomapPublisherOptions& options,
                                                 const semantic_slam::LabelVocabulary& vocabulary) {
  semantic_slam::MapProjectionOptions projection;
  projection.min_z_m = options.projected_min_z_m;
  projection.max_z_m = options.projected_max_z_m;
  for (const semantic_slam::LabelId label :
       semantic_slam::FindLabels("projected_left_out", options.projected_left_out, vocabulary)) {
    projection.left_out.set(label);
  }
  return projection;
}

}  // namespace

OctomapPublisher::OctomapPublisher(ros::NodeHandle nh, const OctomapPublisherOptions& options,
                                   const semantic_slam::LabelVocabulary& vocabulary)
    : options_(Checked(options)),
      vocabulary_(vocabulary),
      colours_(ColourModeFromName(options_.colour_mode), vocabulary, options_.low_z_m,
               options_.high_z_m),
      projection_(ProjectionOf(options_, vocabulary)),
      labels_pub_(PublishLabels(nh, vocabulary)) {
  const ros::SubscriberStatusCallback on_connect = [this](const ros::SingleSubscriberPublisher&) {
    somebody_came_ = true;
  };
  const ros::SubscriberStatusCallback on_disconnect;
  // Latched, so that a map that no longer changes reaches also those who come in between.
  markers_pub_ = nh.advertise<visualization_msgs::MarkerArray>(
      topics::kOccupiedCellsMarkers, 1, on_connect, on_disconnect, ros::VoidConstPtr(), true);
  cells_pub_ = nh.advertise<sensor_msgs::PointCloud2>(topics::kOccupiedCells, 1, on_connect,
                                                      on_disconnect, ros::VoidConstPtr(), true);
  legend_pub_ = nh.advertise<visualization_msgs::MarkerArray>(topics::kLegend, 1, true);
  projected_pub_ = nh.advertise<nav_msgs::OccupancyGrid>(topics::kProjectedMap, 1, on_connect,
                                                         on_disconnect, ros::VoidConstPtr(), true);
}

bool OctomapPublisher::IsDue(std::uint64_t version) const {
  const bool wanted = markers_pub_.getNumSubscribers() > 0 || cells_pub_.getNumSubscribers() > 0 ||
                      legend_pub_.getNumSubscribers() > 0 || projected_pub_.getNumSubscribers() > 0;
  return wanted && (version != sent_version_ || somebody_came_);
}

void OctomapPublisher::Collect(const semantic_slam::SemanticMapper& mapper) {
  somebody_came_ = false;
  sent_version_ = mapper.version();
  header_ = MakeHeader(mapper.stamp(), options_.map_frame);
  cells_ = CollectOccupiedCells(mapper.tree(), colours_);
  projected_ = {};
  if (projected_pub_.getNumSubscribers() > 0)
    projected_ = semantic_slam::ProjectDown(mapper.tree(), projection_);
}

void OctomapPublisher::Send() {
  if (markers_pub_.getNumSubscribers() > 0) {
    markers_pub_.publish(ToMarkers(cells_, header_, options_.markers_max_z_m));
  }
  if (cells_pub_.getNumSubscribers() > 0) cells_pub_.publish(ToPointCloud2(cells_, header_));
  if (projected_pub_.getNumSubscribers() > 0)
    projected_pub_.publish(ToOccupancyGrid(projected_, header_));
  std::vector<semantic_slam::LabelId> labels = LabelsIn(cells_);
  if (labels == legend_) return;
  legend_ = std::move(labels);
  legend_pub_.publish(ToLegend(cells_, vocabulary_, header_));
}

}  // namespace semantic_slam_ros
