#include "semantic_slam_ros/path_history.h"

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::KeyframeGraph;
using semantic_slam::Rigid3d;
using semantic_slam::Stamp;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;

Rigid3d At(double x_m) {
  return Rigid3d(Eigen::Translation3d(x_m, 0.0, 0.0));
}

// Image number n, n metres ahead of keyframe 0.
TrackedImage Image(int n) {
  TrackedImage image;
  image.stamp = Stamp{1000 + n};
  image.status = TrackingStatus::kTracking;
  image.keyframe_id = 0;
  image.T_keyframe_camera = At(n);
  return image;
}

KeyframeGraph Graph(double keyframe_x_m) {
  KeyframeGraph graph;
  graph.keyframes.resize(1);
  graph.keyframes[0].id = 0;
  graph.keyframes[0].T_map_keyframe = At(keyframe_x_m);
  return graph;
}

TEST(PathHistoryTest, FollowsTheCorrectionOfItsKeyframe) {
  PathHistory history(10);
  history.Add(Image(3), At(0.5));
  const auto before = history.Poses(Graph(0.0));
  const auto after = history.Poses(Graph(10.0));
  ASSERT_EQ(before.size(), 1u);
  EXPECT_DOUBLE_EQ(before[0].pose.translation().x(), 3.5);
  EXPECT_DOUBLE_EQ(after[0].pose.translation().x(), 13.5);
}

TEST(PathHistoryTest, KeepsAtMostSoManyAndThinsEvenly) {
  PathHistory history(4);
  for (int n = 0; n < 9; ++n) history.Add(Image(n), Rigid3d::Identity());
  std::vector<std::int64_t> kept;
  for (const auto& pose : history.Poses(Graph(0.0))) kept.push_back(pose.stamp.ns - 1000);
  EXPECT_EQ(kept, (std::vector<std::int64_t>{0, 4, 8}));
  for (int n = 9; n < 5000; ++n) {
    history.Add(Image(n), Rigid3d::Identity());
    ASSERT_LE(history.Poses(Graph(0.0)).size(), 4u);
  }
}

TEST(PathHistoryTest, LeavesOutWhatWasNotTracked) {
  PathHistory history(4);
  TrackedImage lost = Image(0);
  lost.status = TrackingStatus::kLost;
  history.Add(lost, Rigid3d::Identity());
  EXPECT_TRUE(history.Poses(Graph(0.0)).empty());
}

TEST(PathHistoryTest, ShowsTheMapsThatTheGraphTellsOf) {
  PathHistory history(4);
  history.Add(Image(0), Rigid3d::Identity());
  TrackedImage of_new_map = Image(1);
  of_new_map.map_id = 1;
  of_new_map.keyframe_id = 5;
  history.Add(of_new_map, Rigid3d::Identity());
  KeyframeGraph graph = Graph(0.0);
  EXPECT_EQ(history.Poses(graph).size(), 1u);
  graph.map_id = 1;
  graph.keyframes.push_back(graph.keyframes[0]);
  graph.keyframes[1].id = 5;
  EXPECT_EQ(history.Poses(graph).size(), 2u);  // joined
}

}  // namespace
}  // namespace semantic_slam_ros
