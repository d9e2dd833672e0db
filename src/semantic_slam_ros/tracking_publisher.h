#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <image_transport/image_transport.h>
#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>

#include "semantic_slam/common/throttle.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam_ros/path_history.h"
#include "semantic_slam_ros/tracking_stage.h"

namespace semantic_slam_ros {

struct TrackingPublisherOptions {
  std::string map_frame = "map";
  std::string odom_frame = "odom";  // empty: tf is map -> base and odometry is in the map frame
  std::string base_frame = "base_link";
  bool publish_tf = true;
  double path_period_s = 0.2;        // of the images' stamps
  int path_max_poses = 4000;         // longer paths are thinned out
  double map_points_period_s = 1.0;  // of the images' stamps

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("map_frame", self.map_frame);
    visit("odom_frame", self.odom_frame);
    visit("base_frame", self.base_frame);
    visit("publish_tf", self.publish_tf);
    visit("path_period_s", self.path_period_s, 0.0, 60.0);
    visit("path_max_poses", self.path_max_poses, 2, 1000000);
    visit("map_points_period_s", self.map_points_period_s, 0.0, 600.0);
  }
};

// Tells the world about tracked images: TrackingState, keyframes, tf and odometry always; path, map
// points and the debug image when somebody listens. Everything carries the image's stamp. For one
// thread.
class TrackingPublisher {
 public:
  // Frames in `options` are without leading slash.
  TrackingPublisher(ros::NodeHandle nh, const TrackingPublisherOptions& options);

  void Publish(const TrackedFrame& frame,
               const semantic_slam::VisualLocalization& localization);

 private:
  // What the odometry said of an image.
  struct OdometryPose {
    semantic_slam::Stamp stamp;
    semantic_slam::Rigid3d T_odom_base;
    semantic_slam::Matrix6d covariance;  // of that, along the axes of odom
    int map_id;
  };

  void PublishTransforms(semantic_slam::Stamp stamp, const semantic_slam::Rigid3d& T_map_base,
                         const semantic_slam::Rigid3d& T_odom_base);
  void PublishOdometry(const TrackedFrame& frame);
  void PublishKeyframes(const semantic_slam::VisualLocalization& localization);
  void PublishPath(const TrackedFrame& frame,
                   const semantic_slam::VisualLocalization& localization);
  void PublishMapPoints(semantic_slam::Stamp stamp,
                        const semantic_slam::VisualLocalization& localization);
  void PublishDebugImage(const TrackedFrame& frame,
                         const semantic_slam::VisualLocalization& localization);

  const TrackingPublisherOptions options_;
  tf2_ros::TransformBroadcaster tf_broadcaster_;
  ros::Publisher state_pub_;
  ros::Publisher keyframes_pub_;
  ros::Publisher odometry_pub_;
  ros::Publisher path_pub_;
  ros::Publisher map_points_pub_;
  image_transport::Publisher debug_image_pub_;
  PathHistory path_;
  semantic_slam::Throttle path_throttle_;
  semantic_slam::Throttle map_points_throttle_;
  std::optional<OdometryPose> last_odometry_;
  std::optional<std::uint64_t> published_revision_;
};

}  // namespace semantic_slam_ros
