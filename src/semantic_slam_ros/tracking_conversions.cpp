#include "semantic_slam_ros/tracking_conversions.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>

#include <sensor_msgs/point_cloud2_iterator.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

using semantic_slam::InputError;
using semantic_slam::KeyframeNode;
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
static_assert(KeyframeArrayMsg::REASON_LOST == static_cast<std::uint8_t>(RevisionReason::kLost));
static_assert(TrackingStateMsg::NO_KEYFRAME == semantic_slam::kNoKeyframe);
static_assert(KeyframeMsg::NO_PARENT == semantic_slam::kNoKeyframe);

namespace {

KeyframeMsg ToKeyframe(const KeyframeNode& node) {
  KeyframeMsg msg;
  msg.id = node.id;
  msg.stamp = ToRos(node.stamp);
  msg.T_map_keyframe = ToPose(node.T_map_keyframe);
  msg.parent_id = node.parent_id;
  msg.T_parent_keyframe = ToPose(node.T_parent_keyframe);
  msg.culled = node.culled;
  return msg;
}

KeyframeNode ToKeyframeNode(const KeyframeMsg& msg) try {
  KeyframeNode node;
  node.id = msg.id;
  node.stamp = ToStamp(msg.stamp);
  node.T_map_keyframe = ToRigid(msg.T_map_keyframe);
  node.parent_id = msg.parent_id;
  node.T_parent_keyframe = ToRigid(msg.T_parent_keyframe);
  node.culled = msg.culled;
  return node;
} catch (const InputError& e) {
  throw InputError("keyframes: keyframe " + std::to_string(msg.id) + ": " + e.what());
}

bool Lists(const std::vector<KeyframeNode>& keyframes, semantic_slam::KeyframeId id) {
  const auto at = std::lower_bound(
      keyframes.begin(), keyframes.end(), id,
      [](const KeyframeNode& node, semantic_slam::KeyframeId wanted) { return node.id < wanted; });
  return at != keyframes.end() && at->id == id;
}

void CheckKeyframes(const std::vector<KeyframeNode>& keyframes) {
  semantic_slam::KeyframeId last = semantic_slam::kNoKeyframe;
  for (const KeyframeNode& node : keyframes) {
    if (node.id <= last) {
      throw InputError("keyframes: keyframe " + std::to_string(node.id) + " follows " +
                       std::to_string(last) + ", expected ascending ids");
    }
    last = node.id;
  }
  for (const KeyframeNode& node : keyframes) {
    if (node.parent_id == semantic_slam::kNoKeyframe) continue;
    if (node.parent_id != node.id && Lists(keyframes, node.parent_id)) continue;
    throw InputError("keyframes: parent of keyframe " + std::to_string(node.id) + " is " +
                     std::to_string(node.parent_id) + ", which is not listed");
  }
}

void ReadPoses(const TrackingStateMsg& msg, semantic_slam::TrackedImage& image) {
  if (msg.keyframe_id < 0) {
    throw InputError("keyframe_id is " + std::to_string(msg.keyframe_id) + " while tracking");
  }
  image.keyframe_id = msg.keyframe_id;
  image.T_keyframe_camera = ToRigid(msg.T_keyframe_camera);
  image.T_map_camera = ToRigid(msg.T_map_camera);
  image.T_odom_camera = ToRigid(msg.T_odom_camera);
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

semantic_slam::TrackedImage ToTrackedImage(const TrackingStateMsg& msg) try {
  if (msg.header.stamp.isZero()) throw InputError("has no stamp");
  if (msg.state > TrackingStateMsg::STATE_LOST) {
    throw InputError("state is " + std::to_string(msg.state) + ", expected 0 to 2");
  }
  semantic_slam::TrackedImage image;
  image.stamp = ToStamp(msg.header.stamp);
  image.status = static_cast<TrackingStatus>(msg.state);
  image.map_id = msg.map_id;
  image.is_keyframe = msg.is_keyframe;
  constexpr std::uint32_t kMaxInt = std::numeric_limits<int>::max();
  image.inliers = static_cast<int>(std::min(msg.inliers, kMaxInt));
  if (image.status == TrackingStatus::kTracking) ReadPoses(msg, image);
  return image;
} catch (const InputError& e) {
  throw InputError(std::string("tracking_state: ") + e.what());
}

KeyframeArrayMsg ToKeyframeArray(const semantic_slam::KeyframeGraph& graph,
                                 const std::string& map_frame) {
  KeyframeArrayMsg msg;
  const Stamp newest = graph.keyframes.empty() ? Stamp() : graph.keyframes.back().stamp;
  msg.header = MakeHeader(newest, map_frame);
  msg.map_id = graph.map_id;
  msg.revision = graph.revision;
  msg.reason = static_cast<std::uint8_t>(graph.reason);
  const semantic_slam::MapMerge none{KeyframeArrayMsg::NO_MAP, KeyframeArrayMsg::NO_MAP};
  const semantic_slam::MapMerge merge = graph.merge.value_or(none);
  msg.old_map_id = merge.old_map_id;
  msg.new_map_id = merge.new_map_id;
  msg.T_new_old = ToPose(merge.T_new_old);
  msg.keyframes.reserve(graph.keyframes.size());
  for (const auto& node : graph.keyframes) msg.keyframes.push_back(ToKeyframe(node));
  return msg;
}

semantic_slam::KeyframeGraph ToKeyframeGraph(const KeyframeArrayMsg& msg) {
  if (msg.reason > KeyframeArrayMsg::REASON_LOST) {
    throw InputError("keyframes: reason is " + std::to_string(msg.reason) + ", expected 0 to 5");
  }
  semantic_slam::KeyframeGraph graph;
  graph.map_id = msg.map_id;
  graph.revision = msg.revision;
  graph.reason = static_cast<RevisionReason>(msg.reason);
  if (graph.reason == RevisionReason::kMerge) {
    graph.merge = semantic_slam::MapMerge{msg.old_map_id, msg.new_map_id, ToRigid(msg.T_new_old)};
  }
  graph.keyframes.reserve(msg.keyframes.size());
  for (const KeyframeMsg& keyframe : msg.keyframes) {
    graph.keyframes.push_back(ToKeyframeNode(keyframe));
  }
  CheckKeyframes(graph.keyframes);
  return graph;
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
