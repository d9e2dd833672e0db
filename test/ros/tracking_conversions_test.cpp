#include "semantic_slam_ros/tracking_conversions.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {
namespace {

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
  graph.keyframes = {{3, Stamp{10}, SomePose(), semantic_slam::kNoKeyframe, Rigid3d::Identity(), false},
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
