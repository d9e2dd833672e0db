#include "semantic_slam_ros/tracking_publisher.h"

#include <vector>

#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <semantic_slam/KeyframeArray.h>
#include <semantic_slam/TrackingState.h>
#include <sensor_msgs/PointCloud2.h>

#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/feature_drawing.h"
#include "semantic_slam_ros/tracking_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::Matrix6d;
using semantic_slam::MovedPoseCovariance;
using semantic_slam::SecondsBetween;
using semantic_slam::TrackedImage;
using semantic_slam::TurnedPoseCovariance;
using semantic_slam::VisualLocalization;

namespace {

constexpr int kQueueSize = 10;

void SetVector(const Eigen::Vector3d& v, geometry_msgs::Vector3& msg) {
  msg.x = v.x(), msg.y = v.y(), msg.z = v.z();
}

// Mean velocity from one pose to the next, in the axes of the second, as REP-105 wants a twist.
geometry_msgs::Twist MeanTwist(const Rigid3d& T_odom_before, const Rigid3d& T_odom_now,
                               double seconds) {
  const Eigen::AngleAxisd turn(T_odom_before.linear().transpose() * T_odom_now.linear());
  const Eigen::Vector3d shift = T_odom_now.translation() - T_odom_before.translation();
  geometry_msgs::Twist msg;
  SetVector(T_odom_now.linear().transpose() * shift / seconds, msg.linear);
  SetVector(turn.axis() * turn.angle() / seconds, msg.angular);
  return msg;
}

// Of T_odom_base: the pose in the map is turned into odom's axes, and moved to the base.
Matrix6d OdomCovariance(const TrackedImage& tracked, const Rigid3d& T_camera_base) {
  const Eigen::Matrix3d R_odom_map =
      tracked.T_odom_camera.linear() * tracked.T_map_camera.linear().transpose();
  return MovedPoseCovariance(TurnedPoseCovariance(tracked.covariance, R_odom_map),
                             tracked.T_odom_camera, T_camera_base.translation());
}

// The message has it row by row.
void SetCovariance(const Matrix6d& covariance, boost::array<double, 36>& msg) {
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(msg.data()) = covariance;
}

}  // namespace

TrackingPublisher::TrackingPublisher(ros::NodeHandle nh, const TrackingPublisherOptions& options)
    : options_(options),
      state_pub_(nh.advertise<semantic_slam::TrackingState>(topics::kTrackingState, kQueueSize)),
      keyframes_pub_(nh.advertise<semantic_slam::KeyframeArray>(topics::kKeyframes, 1, true)),
      odometry_pub_(nh.advertise<nav_msgs::Odometry>(topics::kOdometry, kQueueSize)),
      path_pub_(nh.advertise<nav_msgs::Path>(topics::kPath, 1)),
      map_points_pub_(nh.advertise<sensor_msgs::PointCloud2>(topics::kMapPoints, 1)),
      debug_image_pub_(image_transport::ImageTransport(nh).advertise(topics::kDebugImage, 1)),
      path_(static_cast<std::size_t>(options.path_max_poses)),
      path_throttle_(options.path_period_s),
      map_points_throttle_(options.map_points_period_s) {}

void TrackingPublisher::Publish(const TrackedFrame& frame,
                                const VisualLocalization& localization) {
  const TrackedImage& tracked = frame.tracked;
  path_.Add(tracked, frame.T_base_camera.inverse());
  // The graph first: then the keyframe that the state speaks of is known to who gets both.
  PublishKeyframes(localization);
  state_pub_.publish(ToTrackingState(tracked, options_.map_frame, frame.camera_frame));
  if (tracked.status == semantic_slam::TrackingStatus::kTracking) {
    const Rigid3d T_camera_base = frame.T_base_camera.inverse();
    const Rigid3d T_map_base = tracked.T_map_camera * T_camera_base;
    const Rigid3d T_odom_base = tracked.T_odom_camera * T_camera_base;
    PublishTransforms(tracked.stamp, T_map_base, T_odom_base);
    PublishOdometry(frame);
    PublishPath(frame, localization);
  }
  PublishMapPoints(tracked.stamp, localization);
  PublishDebugImage(frame, localization);
}

void TrackingPublisher::PublishTransforms(Stamp stamp, const Rigid3d& T_map_base,
                                          const Rigid3d& T_odom_base) {
  if (!options_.publish_tf) return;
  const auto& [map, odom, base] =
      std::tie(options_.map_frame, options_.odom_frame, options_.base_frame);
  if (odom.empty()) {
    tf_broadcaster_.sendTransform(ToTransformStamped(stamp, map, base, T_map_base));
    return;
  }
  tf_broadcaster_.sendTransform(std::vector<geometry_msgs::TransformStamped>{
      ToTransformStamped(stamp, map, odom, semantic_slam::MapFromOdom(T_map_base, T_odom_base)),
      ToTransformStamped(stamp, odom, base, T_odom_base)});
}

void TrackingPublisher::PublishOdometry(const TrackedFrame& frame) {
  const TrackedImage& tracked = frame.tracked;
  const Rigid3d T_camera_base = frame.T_base_camera.inverse();
  const OdometryPose now{tracked.stamp, tracked.T_odom_camera * T_camera_base,
                         OdomCovariance(tracked, T_camera_base), tracked.map_id};
  const bool in_map = options_.odom_frame.empty();
  const Eigen::Matrix3d R_map_odom =
      tracked.T_map_camera.linear() * tracked.T_odom_camera.linear().transpose();
  nav_msgs::Odometry msg;
  msg.header = MakeHeader(tracked.stamp, in_map ? options_.map_frame : options_.odom_frame);
  msg.child_frame_id = options_.base_frame;
  msg.pose.pose = ToPose(in_map ? tracked.T_map_camera * T_camera_base : now.T_odom_base);
  SetCovariance(in_map ? TurnedPoseCovariance(now.covariance, R_map_odom) : now.covariance,
                msg.pose.covariance);
  Matrix6d twist_covariance = semantic_slam::UnknownPoseCovariance();
  if (last_odometry_ && last_odometry_->map_id == tracked.map_id &&
      last_odometry_->stamp < tracked.stamp) {
    const double seconds = SecondsBetween(last_odometry_->stamp, tracked.stamp);
    msg.twist.twist = MeanTwist(last_odometry_->T_odom_base, now.T_odom_base, seconds);
    // As if the errors of the two poses had nothing to do with each other: most is theirs alone.
    twist_covariance = TurnedPoseCovariance(last_odometry_->covariance + now.covariance,
                                            now.T_odom_base.linear().transpose()) /
                       (seconds * seconds);
  }
  SetCovariance(twist_covariance, msg.twist.covariance);
  last_odometry_ = now;
  odometry_pub_.publish(msg);
}

void TrackingPublisher::PublishKeyframes(const VisualLocalization& localization) {
  if (localization.revision() == published_revision_) return;
  const semantic_slam::KeyframeGraph graph = localization.keyframe_graph();
  published_revision_ = graph.revision;
  keyframes_pub_.publish(ToKeyframeArray(graph, options_.map_frame));
}

void TrackingPublisher::PublishPath(const TrackedFrame& frame,
                                    const VisualLocalization& localization) {
  if (path_pub_.getNumSubscribers() == 0 || !path_throttle_.IsDue(frame.tracked.stamp)) return;
  const semantic_slam::Trajectory poses = path_.Poses(localization.keyframe_graph());
  if (!poses.empty()) path_pub_.publish(ToPath(poses, options_.map_frame));
}

void TrackingPublisher::PublishMapPoints(Stamp stamp, const VisualLocalization& localization) {
  if (map_points_pub_.getNumSubscribers() == 0 || !map_points_throttle_.IsDue(stamp)) return;
  map_points_pub_.publish(
      ToPointCloud2(localization.map_points(), MakeHeader(stamp, options_.map_frame)));
}

void TrackingPublisher::PublishDebugImage(const TrackedFrame& frame,
                                          const VisualLocalization& localization) {
  if (debug_image_pub_.getNumSubscribers() == 0) return;
  const ColourImage drawing = DrawFeatures({frame.image.colour, frame.image.order},
                                           localization.features(), frame.tracked);
  debug_image_pub_.publish(ToImage(drawing, MakeHeader(frame.tracked.stamp, frame.camera_frame)));
}

}  // namespace semantic_slam_ros
