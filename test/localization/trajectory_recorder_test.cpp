#include "semantic_slam/localization/trajectory_recorder.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Rigid3d At(double x_m, double y_m = 0.0) {
  return Rigid3d(Eigen::Translation3d(x_m, y_m, 0.0));
}

TrackedImage Tracked(int second, KeyframeId keyframe, const Rigid3d& T_keyframe_camera,
                     const Rigid3d& T_map_camera) {
  TrackedImage image;
  image.stamp = Stamp::FromSeconds(second);
  image.status = TrackingStatus::kTracking;
  image.keyframe_id = keyframe;
  image.T_keyframe_camera = T_keyframe_camera;
  image.T_map_camera = T_map_camera;
  return image;
}

TrackedImage NotTracked(int second, TrackingStatus status) {
  TrackedImage image;
  image.stamp = Stamp::FromSeconds(second);
  image.status = status;
  return image;
}

KeyframeNode Node(KeyframeId id, const Rigid3d& T_map_keyframe, bool culled = false) {
  KeyframeNode node;
  node.id = id;
  node.stamp = Stamp::FromSeconds(static_cast<double>(id));
  node.T_map_keyframe = T_map_keyframe;
  node.culled = culled;
  return node;
}

KeyframeGraph Graph(int map_id, std::vector<KeyframeNode> keyframes) {
  KeyframeGraph graph;
  graph.map_id = map_id;
  graph.keyframes = std::move(keyframes);
  return graph;
}

TEST(TrajectoryRecorderTest, CountsWhatItDoesNotKeep) {
  TrajectoryRecorder recorder;
  recorder.Add(NotTracked(0, TrackingStatus::kInitializing));
  recorder.Add(Tracked(1, 0, At(0.0), At(0.0)));
  recorder.Add(NotTracked(2, TrackingStatus::kLost));
  EXPECT_EQ(recorder.images(), 3u);
  EXPECT_EQ(recorder.tracked(), 1u);
  EXPECT_EQ(recorder.lost(), 1u);
  EXPECT_EQ(recorder.live().size(), 1u);
}

TEST(TrajectoryRecorderTest, TellsTheTrajectoryAgainWithTodaysKeyframes) {
  TrajectoryRecorder recorder;
  recorder.Add(Tracked(0, 0, At(0.0), At(0.0)));
  recorder.Add(Tracked(1, 0, At(1.0), At(1.0)));
  recorder.Add(Tracked(2, 2, At(0.5), At(2.5)));
  // The map was corrected: keyframe 2 lies 0.1 m to the left and looks back. It was culled, too.
  const Rigid3d T_map_keyframe = At(2.0, 0.1) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  const Trajectory corrected =
      recorder.Corrected(Graph(0, {Node(0, At(0.0)), Node(2, T_map_keyframe, true)}));
  ASSERT_EQ(corrected.size(), 3u);
  EXPECT_TRUE(corrected[1].pose.isApprox(At(1.0)));
  EXPECT_EQ(corrected[2].stamp, Stamp::FromSeconds(2));
  EXPECT_TRUE(corrected[2].pose.translation().isApprox(Eigen::Vector3d(1.5, 0.1, 0.0), 1e-12));
  EXPECT_TRUE(recorder.live()[2].pose.isApprox(At(2.5)));  // as it was published
}

// Keyframe ids are never used again: a graph lists those of joined maps, and of no others.
TEST(TrajectoryRecorderTest, HasImagesOfJoinedMaps) {
  TrajectoryRecorder recorder;
  recorder.Add(Tracked(0, 0, At(0.0), At(0.0)));
  TrackedImage of_new_map = Tracked(1, 1, At(0.0), At(0.0));
  of_new_map.map_id = 1;
  recorder.Add(of_new_map);
  EXPECT_EQ(recorder.Corrected(Graph(1, {Node(1, At(0.0))})).size(), 1u);
  const Trajectory joined = recorder.Corrected(Graph(1, {Node(0, At(0.0)), Node(1, At(7.0))}));
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_TRUE(joined[1].pose.isApprox(At(7.0)));
}

TEST(TrajectoryRecorderTest, LeavesOutImagesWhoseKeyframeIsUnknown) {
  TrajectoryRecorder recorder;
  recorder.Add(Tracked(0, 5, At(0.0), At(0.0)));
  EXPECT_TRUE(recorder.Corrected(Graph(0, {Node(0, At(0.0))})).empty());
  EXPECT_TRUE(TrajectoryRecorder().Corrected(KeyframeGraph()).empty());
}

TEST(KeyframeTrajectoryTest, HasTheKeyframesThatWereNotCulled) {
  const Trajectory trajectory =
      KeyframeTrajectory(Graph(0, {Node(0, At(0.0)), Node(1, At(1.0), true), Node(4, At(2.0))}));
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[1].stamp, Stamp::FromSeconds(4));
  EXPECT_TRUE(trajectory[1].pose.isApprox(At(2.0)));
}

}  // namespace
}  // namespace semantic_slam
