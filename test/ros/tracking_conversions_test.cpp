#include "semantic_slam_ros/tracking_conversions.h"

#include <limits>

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "testing/expect_error.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::InputError;
using semantic_slam::MessageOf;
using KeyframeArrayMsg = semantic_slam::KeyframeArray;
using StateMsg = semantic_slam::TrackingState;

Rigid3d SomePose() {
  return Eigen::Translation3d(1.0, 2.0, 3.0) *
         Eigen::AngleAxisd(0.5, Eigen::Vector3d(1.0, 2.0, 2.0).normalized());
}

TEST(TrackingConversionsTest, TrackingStateKeepsEveryField) {
  semantic_slam::TrackedImage image;
  image.stamp = Stamp{1305031453359684001};
  image.status = semantic_slam::TrackingStatus::kTracking;
  image.map_id = 2;
  image.keyframe_id = 41;
  image.T_keyframe_camera = SomePose();
  image.T_map_camera = SomePose().inverse();
  image.T_odom_camera = SomePose() * SomePose();
  image.inliers = 123;
  image.is_keyframe = true;
  const StateMsg msg = ToTrackingState(image, "map", "camera");
  EXPECT_EQ(ToStamp(msg.header.stamp), image.stamp);
  EXPECT_EQ(msg.header.frame_id, "map");
  EXPECT_EQ(msg.child_frame_id, "camera");
  EXPECT_EQ(msg.state, StateMsg::STATE_TRACKING);
  EXPECT_EQ(msg.map_id, 2);
  EXPECT_EQ(msg.keyframe_id, 41);
  EXPECT_EQ(msg.inliers, 123u);
  EXPECT_TRUE(msg.is_keyframe);
  // 1e-12: a quaternion in between.
  EXPECT_TRUE(ToRigid(msg.T_keyframe_camera).isApprox(image.T_keyframe_camera, 1e-12));
  EXPECT_TRUE(ToRigid(msg.T_map_camera).isApprox(image.T_map_camera, 1e-12));
  EXPECT_TRUE(ToRigid(msg.T_odom_camera).isApprox(image.T_odom_camera, 1e-12));
}

TEST(TrackingConversionsTest, KeyframeArrayIsTheWholeGraph) {
  semantic_slam::KeyframeGraph graph;
  graph.map_id = 1;
  graph.revision = 17;
  graph.reason = semantic_slam::RevisionReason::kLoop;
  graph.keyframes = {
      {3, Stamp{10}, SomePose(), semantic_slam::kNoKeyframe, Rigid3d::Identity(), false},
      {4, Stamp{20}, SomePose().inverse(), 3, SomePose(), true}};
  const KeyframeArrayMsg msg = ToKeyframeArray(graph, "map");
  EXPECT_EQ(ToStamp(msg.header.stamp), Stamp{20});
  EXPECT_EQ(msg.map_id, 1);
  EXPECT_EQ(msg.revision, 17u);
  EXPECT_EQ(msg.reason, KeyframeArrayMsg::REASON_LOOP);
  EXPECT_EQ(msg.old_map_id, KeyframeArrayMsg::NO_MAP);
  ASSERT_EQ(msg.keyframes.size(), 2u);
  EXPECT_EQ(msg.keyframes[0].parent_id, semantic_slam::KeyframePose::NO_PARENT);
  EXPECT_EQ(msg.keyframes[1].parent_id, 3);
  EXPECT_TRUE(msg.keyframes[1].culled);
  EXPECT_TRUE(ToRigid(msg.keyframes[1].T_parent_keyframe).isApprox(SomePose(), 1e-12));
}

TEST(TrackingConversionsTest, EmptyGraphIsAnEmptyArray) {
  EXPECT_TRUE(ToKeyframeArray(semantic_slam::KeyframeGraph(), "map").keyframes.empty());
}

StateMsg GoodState() {
  semantic_slam::TrackedImage image;
  image.stamp = Stamp{1305031453359684001};
  image.status = semantic_slam::TrackingStatus::kTracking;
  image.map_id = 2;
  image.keyframe_id = 41;
  image.T_keyframe_camera = SomePose();
  image.T_map_camera = SomePose().inverse();
  image.T_odom_camera = SomePose() * SomePose();
  image.inliers = 123;
  image.is_keyframe = true;
  return ToTrackingState(image, "map", "camera");
}

std::string StateError(const StateMsg& msg) {
  return MessageOf<InputError>([&] { ToTrackedImage(msg); });
}

TEST(TrackingConversionsTest, ReadsAStateBack) {
  const semantic_slam::TrackedImage image = ToTrackedImage(GoodState());
  EXPECT_EQ(image.stamp, Stamp{1305031453359684001});
  EXPECT_EQ(image.status, semantic_slam::TrackingStatus::kTracking);
  EXPECT_EQ(image.map_id, 2);
  EXPECT_EQ(image.keyframe_id, 41);
  EXPECT_EQ(image.inliers, 123);
  EXPECT_TRUE(image.is_keyframe);
  // 1e-12: a quaternion in between.
  EXPECT_TRUE(image.T_keyframe_camera.isApprox(SomePose(), 1e-12));
  EXPECT_TRUE(image.T_map_camera.isApprox(SomePose().inverse(), 1e-12));
  EXPECT_TRUE(image.T_odom_camera.isApprox(SomePose() * SomePose(), 1e-12));
}

TEST(TrackingConversionsTest, DoesNotLookAtPosesOfALostCamera) {
  StateMsg msg = GoodState();
  msg.state = StateMsg::STATE_LOST;
  msg.T_map_camera = geometry_msgs::Pose();  // no rotation
  const semantic_slam::TrackedImage image = ToTrackedImage(msg);
  EXPECT_EQ(image.status, semantic_slam::TrackingStatus::kLost);
  EXPECT_TRUE(image.T_map_camera.isApprox(Rigid3d::Identity()));
  EXPECT_EQ(image.keyframe_id, semantic_slam::kNoKeyframe);
}

TEST(TrackingConversionsTest, RefusesStatesThatAreNone) {
  StateMsg msg = GoodState();
  msg.header.stamp = ros::Time();
  EXPECT_EQ(StateError(msg), "tracking_state: has no stamp");
  msg = GoodState();
  msg.state = 3;
  EXPECT_EQ(StateError(msg), "tracking_state: state is 3, expected 0 to 2");
  msg = GoodState();
  msg.keyframe_id = StateMsg::NO_KEYFRAME;
  EXPECT_EQ(StateError(msg), "tracking_state: keyframe_id is -1 while tracking");
  for (auto pose :
       {&StateMsg::T_keyframe_camera, &StateMsg::T_map_camera, &StateMsg::T_odom_camera}) {
    msg = GoodState();
    (msg.*pose).position.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(StateError(msg), "tracking_state: transform has a number that is not finite");
  }
}

KeyframeArrayMsg GoodGraph() {
  semantic_slam::KeyframeGraph graph;
  graph.map_id = 1;
  graph.revision = 17;
  graph.reason = semantic_slam::RevisionReason::kLoop;
  graph.keyframes = {
      {3, Stamp{10}, SomePose(), semantic_slam::kNoKeyframe, Rigid3d::Identity(), false},
      {4, Stamp{20}, SomePose().inverse(), 3, SomePose(), true}};
  return ToKeyframeArray(graph, "map");
}

std::string GraphError(const KeyframeArrayMsg& msg) {
  return MessageOf<InputError>([&] { ToKeyframeGraph(msg); });
}

TEST(TrackingConversionsTest, ReadsAGraphBack) {
  const semantic_slam::KeyframeGraph graph = ToKeyframeGraph(GoodGraph());
  EXPECT_EQ(graph.map_id, 1);
  EXPECT_EQ(graph.revision, 17u);
  EXPECT_EQ(graph.reason, semantic_slam::RevisionReason::kLoop);
  ASSERT_EQ(graph.keyframes.size(), 2u);
  EXPECT_EQ(graph.keyframes[0].parent_id, semantic_slam::kNoKeyframe);
  EXPECT_EQ(graph.keyframes[1].id, 4);
  EXPECT_EQ(graph.keyframes[1].stamp, Stamp{20});
  EXPECT_EQ(graph.keyframes[1].parent_id, 3);
  EXPECT_TRUE(graph.keyframes[1].culled);
  EXPECT_TRUE(graph.keyframes[1].T_map_keyframe.isApprox(SomePose().inverse(), 1e-12));
  EXPECT_TRUE(graph.keyframes[1].T_parent_keyframe.isApprox(SomePose(), 1e-12));
}

TEST(TrackingConversionsTest, ReadsAnEmptyGraph) {
  EXPECT_TRUE(ToKeyframeGraph(KeyframeArrayMsg()).keyframes.empty());
}

TEST(TrackingConversionsTest, RefusesGraphsThatAreNone) {
  KeyframeArrayMsg msg = GoodGraph();
  msg.reason = 6;
  EXPECT_EQ(GraphError(msg), "keyframes: reason is 6, expected 0 to 5");
  msg = GoodGraph();
  msg.keyframes[1].id = 3;
  EXPECT_EQ(GraphError(msg), "keyframes: keyframe 3 follows 3, expected ascending ids");
  msg = GoodGraph();
  msg.keyframes[0].id = -1;
  EXPECT_EQ(GraphError(msg), "keyframes: keyframe -1 follows -1, expected ascending ids");
  msg = GoodGraph();
  msg.keyframes[1].parent_id = 2;
  EXPECT_EQ(GraphError(msg), "keyframes: parent of keyframe 4 is 2, which is not listed");
  msg.keyframes[1].parent_id = 4;
  EXPECT_EQ(GraphError(msg), "keyframes: parent of keyframe 4 is 4, which is not listed");
  msg = GoodGraph();
  msg.keyframes[1].T_map_keyframe = geometry_msgs::Pose();
  EXPECT_EQ(GraphError(msg),
            "keyframes: keyframe 4: transform's quaternion has length 0.000000, expected 1");
}

TEST(TrackingConversionsTest, PathHasAStampedPosePerPose) {
  const nav_msgs::Path msg = ToPath({{Stamp{5}, SomePose()}, {Stamp{9}, SomePose()}}, "map");
  EXPECT_EQ(ToStamp(msg.header.stamp), Stamp{9});
  ASSERT_EQ(msg.poses.size(), 2u);
  EXPECT_EQ(ToStamp(msg.poses[0].header.stamp), Stamp{5});
  EXPECT_EQ(msg.poses[0].header.frame_id, "map");
}

TEST(TrackingConversionsTest, CloudHasPositionsAndColours) {
  const sensor_msgs::PointCloud2 msg =
      ToPointCloud2({{{1.0f, 2.0f, 3.0f}, {10, 20, 30}}}, MakeHeader(Stamp{1}, "map"));
  ASSERT_EQ(msg.width * msg.height, 1u);
  const sensor_msgs::PointCloud2ConstIterator<float> z(msg, "z");
  const sensor_msgs::PointCloud2ConstIterator<std::uint8_t> red(msg, "r"), blue(msg, "b");
  EXPECT_EQ(*z, 3.0f);
  EXPECT_EQ(*red, 10);
  EXPECT_EQ(*blue, 30);
}

}  // namespace
}  // namespace semantic_slam_ros
