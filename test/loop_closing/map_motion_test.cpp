#include "semantic_slam/loop_closing/map_motion.h"

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// Three keyframes in a row, each the next one's parent, with points of their own.
class MapMotionTest : public testing::Test {
 protected:
  MapMotionTest() : map_(SmallExtractor().scales()) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      Rigid3d T = Rigid3d::Identity();
      T.translation().x() = i;
      AddKeyframeWithPoints(map_, SquaresFeatures(i + 1), T);
    }
  }

  const MapPoint& PointOf(KeyframeId id) const {
    return *map_.FindPoint(map_.FindKeyframe(id)->points[0]);
  }

  Map map_;
};

TEST_F(MapMotionTest, KeyframesGoWhereTheyAreSent) {
  const Rigid3d target = Nudged(map_.KeyframePose(1), 0.5, 0.2, 3);
  MoveKeyframes({{1, target}}, map_);
  EXPECT_LT(DistanceBetween(map_.KeyframePose(1), target), 1e-12);
  EXPECT_LT(AngleBetween(map_.KeyframePose(1), target), 1e-7);
}

TEST_F(MapMotionTest, ChildrenFollowAndParentsDoNot) {
  const Rigid3d T_1_2 = map_.KeyframePose(1).inverse() * map_.KeyframePose(2);
  const Rigid3d first = map_.KeyframePose(0);
  MoveKeyframes({{1, Nudged(map_.KeyframePose(1), 0.5, 0.2, 3)}}, map_);
  EXPECT_LT(DistanceBetween(map_.KeyframePose(1).inverse() * map_.KeyframePose(2), T_1_2), 1e-12);
  EXPECT_EQ(map_.KeyframePose(0).matrix(), first.matrix());
}

TEST_F(MapMotionTest, PointsKeepTheirPlaceInTheirKeyframe) {
  const auto in_keyframe = [&](KeyframeId id) {
    return Eigen::Vector3d(map_.KeyframePose(id).inverse() * PointOf(id).position);
  };
  const auto direction = [&](KeyframeId id) {
    return Eigen::Vector3d(map_.KeyframePose(id).linear().transpose() * PointOf(id).view_direction);
  };
  const Eigen::Vector3d p = in_keyframe(2), d = direction(2);
  MoveKeyframes({{1, Nudged(map_.KeyframePose(1), 0.5, 0.2, 3)}}, map_);
  EXPECT_LT((in_keyframe(2) - p).norm(), 1e-12);
  EXPECT_LT((direction(2) - d).norm(), 1e-12);
}

}  // namespace
}  // namespace semantic_slam
