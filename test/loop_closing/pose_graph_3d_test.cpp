#include "semantic_slam/loop_closing/pose_graph_3d.h"

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// A square of 4 x `side` poses, 1 m apart, that turn left at its corners.
std::vector<Rigid3d> Square(int side) {
  std::vector<Rigid3d> poses{Rigid3d::Identity()};
  Rigid3d step = Rigid3d::Identity();
  step.translation().x() = 1.0;
  Rigid3d corner = step;
  corner.linear() = ExpSo3(Eigen::Vector3d(0.0, 0.0, M_PI / 2));
  for (int i = 1; i < 4 * side; ++i) poses.push_back(poses.back() * (i % side == 0 ? corner : step));
  return poses;
}

// The poses that odometry with an error in each step makes of them, and the steps.
PoseGraph3d DriftedGraph(const std::vector<Rigid3d>& truth) {
  PoseGraph3d graph;
  graph.poses.push_back(truth.front());
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const int a = static_cast<int>(i) - 1;
    const Rigid3d step = Nudged(truth[i - 1].inverse() * truth[i], 0.02, 0.01, static_cast<std::uint32_t>(i));
    graph.edges.push_back({a, a + 1, step, 1.0});
    graph.poses.push_back(graph.poses.back() * step);
  }
  graph.fixed.assign(truth.size(), false);
  graph.fixed.front() = true;
  return graph;
}

double WorstError(const PoseGraph3d& graph, const std::vector<Rigid3d>& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    worst = std::max(worst, DistanceBetween(graph.poses[i], truth[i]));
  }
  return worst;
}

TEST(PoseGraph3dTest, WithoutALoopNothingMoves) {
  PoseGraph3d graph = DriftedGraph(Square(5));
  const std::vector<Rigid3d> before = graph.poses;
  OptimizePoseGraph(graph, PoseGraphOptions());
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT(DistanceBetween(graph.poses[i], before[i]), 1e-9) << i;
  }
}

TEST(PoseGraph3dTest, ALoopTakesTheDriftOut) {
  const std::vector<Rigid3d> truth = Square(5);
  PoseGraph3d graph = DriftedGraph(truth);
  const double before = WorstError(graph, truth);
  const int last = static_cast<int>(truth.size()) - 1;
  graph.edges.push_back({0, last, truth.back(), 10.0});
  OptimizePoseGraph(graph, PoseGraphOptions());
  EXPECT_LT(DistanceBetween(graph.poses.back(), truth.back()), 0.01);
  EXPECT_LT(WorstError(graph, truth), 0.6 * before);  // in the middle the loop knows no better
}

TEST(PoseGraph3dTest, FixedPosesStay) {
  const std::vector<Rigid3d> truth = Square(2);
  PoseGraph3d graph = DriftedGraph(truth);
  graph.poses.back() = truth.back();
  graph.fixed.back() = true;
  OptimizePoseGraph(graph, PoseGraphOptions());
  EXPECT_EQ(graph.poses.front().matrix(), truth.front().matrix());
  EXPECT_EQ(graph.poses.back().matrix(), truth.back().matrix());
}

TEST(PoseGraph3dTest, ExactEdgesAreReachedFromAfar) {
  const std::vector<Rigid3d> truth = Square(3);
  PoseGraph3d graph = DriftedGraph(truth);
  for (RelativePose& edge : graph.edges) edge.T_a_b = truth[edge.a].inverse() * truth[edge.b];
  for (std::size_t i = 1; i < graph.poses.size(); ++i) {
    graph.poses[i] = Nudged(truth[i], 0.3, 0.3, static_cast<std::uint32_t>(i));
  }
  OptimizePoseGraph(graph, PoseGraphOptions());
  EXPECT_LT(WorstError(graph, truth), 1e-5);  // the solver stops when the cost changes by 1e-6 of itself
}

TEST(PoseGraph3dTest, TakesAnEmptyGraphAndLonelyPoses) {
  PoseGraph3d empty;
  OptimizePoseGraph(empty, PoseGraphOptions());
  PoseGraph3d lonely;
  lonely.poses = {Rigid3d::Identity(), Nudged(Rigid3d::Identity(), 1.0, 1.0, 1)};
  lonely.fixed = {true, false};
  const Rigid3d before = lonely.poses[1];
  OptimizePoseGraph(lonely, PoseGraphOptions());
  EXPECT_LT(DistanceBetween(lonely.poses[1], before), 1e-12);
}

}  // namespace
}  // namespace semantic_slam
