#include "semantic_slam/common/keyframe_poses.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Rigid3d At(double x) {
  Rigid3d T = Rigid3d::Identity();
  T.translation().x() = x;
  return T;
}

KeyframeNode Node(KeyframeId id, double x, bool culled) {
  KeyframeNode node;
  node.id = id;
  node.T_map_keyframe = At(x);
  node.culled = culled;
  return node;
}

TEST(KeyframePosesTest, KnowsNothingAtFirst) {
  const KeyframePoses poses;
  EXPECT_EQ(poses.size(), 0u);
  EXPECT_EQ(poses.Find(0), std::nullopt);
}

TEST(KeyframePosesTest, FindsWhatTheGraphListsAlsoIfCulled) {
  KeyframeGraph graph;
  graph.map_id = 3;
  graph.revision = 8;
  graph.keyframes = {Node(2, 0.5, false), Node(7, 1.5, true)};
  const KeyframePoses poses(graph);
  EXPECT_EQ(poses.map_id(), 3);
  EXPECT_EQ(poses.revision(), 8u);
  EXPECT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses.Find(2)->translation().x(), 0.5);
  EXPECT_EQ(poses.Find(7)->translation().x(), 1.5);
  EXPECT_FALSE(poses.Find(3).has_value());
  EXPECT_FALSE(poses.Find(kNoKeyframe).has_value());
}

TEST(DisplacementTest, IsTheShiftOfTheOriginWithoutRotation) {
  EXPECT_EQ(Displacement(At(1.0), At(1.0), 5.0), 0.0);
  EXPECT_DOUBLE_EQ(Displacement(At(1.0), At(1.25), 5.0), 0.25);
}

TEST(DisplacementTest, AddsTheArcOfTheRotation) {
  Rigid3d turned = At(1.0);
  turned.linear() = ExpSo3({0.0, 0.0, 0.1});
  // 1e-12: an angle by way of a rotation matrix.
  EXPECT_NEAR(Displacement(At(1.0), turned, 5.0), 0.5, 1e-12);
  EXPECT_NEAR(Displacement(At(1.0), turned, 0.0), 0.0, 1e-12);
}

TEST(DisplacementTest, DoesNotDependOnWhereTheMapBegins) {
  const Rigid3d T_new_old =
      Eigen::Translation3d(10.0, -4.0, 2.0) * Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ());
  Rigid3d after = At(1.3);
  after.linear() = ExpSo3({0.0, 0.2, 0.0});
  // 1e-9: metres at ten metres from the origin.
  EXPECT_NEAR(Displacement(T_new_old * At(1.0), T_new_old * after, 2.0),
              Displacement(At(1.0), after, 2.0), 1e-9);
}

}  // namespace
}  // namespace semantic_slam
