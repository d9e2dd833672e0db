// How maps begin, are joined and forgotten: src/semantic_slam/map/map_joining.cpp.

#include "map/map_fixture.h"

namespace semantic_slam {
namespace {

// Two maps: one dormant, of keyframes 0 and 1, and the present one, of 2 and 3.
class TwoMapsTest : public MapTest {
 protected:
  TwoMapsTest() {
    AddPair();
    map_.BeginNew(1000);
    AddPair();
  }

  void AddPair() {
    const KeyframeId a = AddKeyframe(), b = AddKeyframe(At(1.0, 0.0, 0.0));
    points_.push_back(AddSharedPoint({a, b}, 0));
    map_.UpdateCovisibility(a);
    map_.UpdateCovisibility(b);
  }

  std::vector<PointId> points_;
};

TEST_F(TwoMapsTest, ThePresentOneIsShownAndTheDormantOneKept) {
  EXPECT_EQ(map_.map_id(), 1);
  EXPECT_EQ(map_.dormant_keyframes(), 2u);
  const KeyframeGraph graph = map_.Graph();
  EXPECT_EQ(graph.map_id, 1);
  EXPECT_EQ(graph.reason, RevisionReason::kLost);
  ASSERT_EQ(graph.keyframes.size(), 2u);
  EXPECT_EQ(graph.keyframes[0].id, 2);
  EXPECT_EQ(graph.keyframes[0].parent_id, kNoKeyframe);  // it has nothing to do with keyframe 1
  EXPECT_EQ(graph.keyframes[1].parent_id, 2);
  EXPECT_EQ(map_.ColouredPoints().size(), 1u);
  EXPECT_NE(map_.FindPoint(points_[0]), nullptr);
  EXPECT_FALSE(map_.IsPresent(*map_.FindKeyframe(1)));
}

TEST_F(TwoMapsTest, JoinedTheyAreOneMapInTheDormantOnesFrame) {
  const Rigid3d T = At(0.0, 5.0, 0.0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  map_.JoinTo(1, T);
  EXPECT_EQ(map_.dormant_keyframes(), 0u);
  const KeyframeGraph graph = map_.Graph();
  EXPECT_EQ(graph.map_id, 1);
  EXPECT_EQ(graph.reason, RevisionReason::kMerge);
  ASSERT_TRUE(graph.merge);
  EXPECT_EQ(graph.merge->old_map_id, 0);
  EXPECT_EQ(graph.merge->new_map_id, 1);
  EXPECT_TRUE(graph.merge->T_new_old.isApprox(Rigid3d::Identity()));
  ASSERT_EQ(graph.keyframes.size(), 4u);
  EXPECT_TRUE(graph.keyframes[1].T_map_keyframe.isApprox(At(1.0, 0.0, 0.0)));
  EXPECT_EQ(graph.keyframes[2].parent_id, 1);
  EXPECT_TRUE(graph.keyframes[2].T_map_keyframe.isApprox(T));
  EXPECT_TRUE(graph.keyframes[3].T_map_keyframe.isApprox(T * At(1.0, 0.0, 0.0)));
  EXPECT_TRUE(map_.FindPoint(points_[1])->position.isApprox(T * Eigen::Vector3d(0.0, 0.0, 2.0)));
  EXPECT_TRUE(map_.FindPoint(points_[0])->position.isApprox(Eigen::Vector3d(0.0, 0.0, 2.0)));
  EXPECT_EQ(map_.ColouredPoints().size(), 2u);
  map_.BumpRevision(RevisionReason::kLocalBa);
  EXPECT_FALSE(map_.Graph().merge);
}

TEST_F(TwoMapsTest, AThirdMapMayBeJoinedToAnOlderOneThanTheSecond) {
  map_.BeginNew(1000);
  AddPair();
  map_.JoinTo(3, Rigid3d::Identity());
  map_.JoinTo(0, At(0.0, 1.0, 0.0));
  const KeyframeGraph graph = map_.Graph();
  EXPECT_EQ(graph.map_id, 2);
  ASSERT_EQ(graph.keyframes.size(), 6u);
  EXPECT_EQ(graph.keyframes[2].parent_id, 0);
  EXPECT_EQ(graph.keyframes[4].parent_id, 3);
}

TEST_F(TwoMapsTest, TheOldestAreForgottenWhereThereAreTooMany) {
  map_.AddLoopEdge({0, 1, Rigid3d::Identity()});
  map_.BeginNew(2);
  EXPECT_EQ(map_.dormant_keyframes(), 2u);
  EXPECT_EQ(map_.FindKeyframe(0), nullptr);
  EXPECT_EQ(map_.FindPoint(points_[0]), nullptr);
  EXPECT_TRUE(map_.loop_edges().empty());
  EXPECT_NE(map_.FindKeyframe(2), nullptr);
  map_.BeginNew(0);
  EXPECT_TRUE(map_.keyframes().empty());
  EXPECT_EQ(map_.point_count(), 0u);
}

TEST_F(TwoMapsTest, ClearingForgetsAll) {
  map_.Clear();
  EXPECT_EQ(map_.map_id(), 2);
  EXPECT_TRUE(map_.keyframes().empty());
}

}  // namespace
}  // namespace semantic_slam
