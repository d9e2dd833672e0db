#include "semantic_slam_ros/message_conversions.h"

#include <cassert>
#include <cstdint>

#include <sensor_msgs/point_cloud2_iterator.h>

#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

using semantic_slam::RevisionReason;
using semantic_slam::TrackingStatus;
using KeyframeMsg = semantic_slam::KeyframePose;
using KeyframeArrayMsg = semantic_slam::KeyframeArray;
using TrackingStateMsg = semantic_slam::TrackingState;

// The enumerations are the same on both sides, so a cast converts them.
static_assert(TrackingStateMsg::STATE_INITIALIZING ==
              static_cast<std::uint8_t>(TrackingStatus::kInitializing));
static_assert(TrackingStateMsg::STATE_TRACKING ==
              static_cast<std::uint8_t>(TrackingStatus::kTracking));
static_assert(TrackingStateMsg::STATE_LOST == static_cast<std::uint8_t>(TrackingStatus::kLost));
static_assert(KeyframeArrayMsg::REASON_LOCAL_BA ==
              static_cast<std::uint8_t>(RevisionReason::kLocalBa));
static_assert(KeyframeArrayMsg::REASON_LOOP == static_cast<std::uint8_t>(RevisionReason::kLoop));
static_assert(KeyframeArrayMsg::REASON_MERGE == static_cast<std::uint8_t>(RevisionReason::kMerge));
static_assert(KeyframeArrayMsg::REASON_LOAD == static_cast<std::uint8_t>(RevisionReason::kLoad));
static_assert(KeyframeArrayMsg::REASON_RESET == static_cast<std::uint8_t>(RevisionReason::kReset));
static_assert(TrackingStateMsg::NO_KEYFRAME == semantic_slam::kNoKeyframe);
static_assert(KeyframeMsg::NO_PARENT == semantic_slam::kNoKeyframe);

namespace {

KeyframeMsg ToKeyframe(const semantic_slam::KeyframeNode& node) {
  KeyframeMsg msg;
  msg.id = node.id;
  msg.stamp = ToRos(node.stamp);
  msg.T_map_keyframe = ToPose(node.T_map_keyframe);
  msg.parent_id = node.parent_id;
  msg.T_parent_keyframe = ToPose(node.T_parent_keyframe);
  msg.culled = node.culled;
  return msg;
}

}  // namespace

TrackingStateMsg ToTrackingState(const semantic_slam::TrackedImage& image,
                                 const std::string& map_frame, const std::string& camera_frame) {
  TrackingStateMsg msg;
  msg.header = MakeHeader(image.stamp, map_frame);
  msg.child_frame_id = camera_frame;
  msg.state = static_cast<std::uint8_t>(image.status);
  msg.map_id = image.map_id;
  msg.keyframe_id = image.keyframe_id;
  msg.is_keyframe = image.is_keyframe;
  msg.T_keyframe_camera = ToPose(image.T_keyframe_camera);
  msg.T_map_camera = ToPose(image.T_map_camera);
  msg.T_odom_camera = ToPose(image.T_odom_camera);
  msg.inliers = static_cast<std::uint32_t>(image.inliers);
  return msg;
}

KeyframeArrayMsg ToKeyframeArray(const semantic_slam::KeyframeGraph& graph,
                                 const std::string& map_frame) {
  KeyframeArrayMsg msg;
  const Stamp newest = graph.keyframes.empty() ? Stamp() : graph.keyframes.back().stamp;
  msg.header = MakeHeader(newest, map_frame);
  msg.map_id = graph.map_id;
  msg.revision = graph.revision;
  msg.reason = static_cast<std::uint8_t>(graph.reason);
  msg.old_map_id = KeyframeArrayMsg::NO_MAP;
  msg.new_map_id = KeyframeArrayMsg::NO_MAP;
  msg.T_new_old = ToPose(Rigid3d::Identity());
  msg.keyframes.reserve(graph.keyframes.size());
  for (const auto& node : graph.keyframes) msg.keyframes.push_back(ToKeyframe(node));
  return msg;
}

nav_msgs::Path ToPath(const semantic_slam::Trajectory& trajectory, const std::string& frame) {
  assert(!trajectory.empty());
  nav_msgs::Path msg;
  msg.header = MakeHeader(trajectory.back().stamp, frame);
  msg.poses.reserve(trajectory.size());
  for (const auto& [stamp, pose] : trajectory) {
    geometry_msgs::PoseStamped stamped;
    stamped.header = MakeHeader(stamp, frame);
    stamped.pose = ToPose(pose);
    msg.poses.push_back(stamped);
  }
  return msg;
}

sensor_msgs::PointCloud2 ToPointCloud2(const std::vector<semantic_slam::ColouredPoint>& points,
                                       const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 msg;
  msg.header = header;
  msg.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(msg);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(points.size());
  sensor_msgs::PointCloud2Iterator<float> xyz(msg, "x");
  sensor_msgs::PointCloud2Iterator<std::uint8_t> bgr(msg, "rgb");  // little-endian 0x00rrggbb
  for (const semantic_slam::ColouredPoint& point : points) {
    for (int i = 0; i < 3; ++i) {
      xyz[i] = point.position[i];
      bgr[i] = point.rgb[2 - i];
    }
    ++xyz;
    ++bgr;
  }
  return msg;
}

}  // namespace semantic_slam_ros
