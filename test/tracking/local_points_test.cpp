#include "semantic_slam/tracking/local_points.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// A keyframe that knows all of its points, and the same image again.
class LocalPointsTest : public testing::Test {
 protected:
  LocalPointsTest()
      : keyframe_(AddKeyframeWithPoints(map_, SquaresFeatures(1), Rigid3d::Identity())) {
    frame_.reference = keyframe_;
  }

  void Match(bool count_visible = true) {
    LocalMatching matching;
    matching.count_visible = count_visible;
    MatchLocalPoints(CollectLocalPoints(map_, 60, frame_), *SmallCamera(), matching, map_, frame_);
  }

  int Matched() const {
    return static_cast<int>(frame_.points.size() -
                            std::count(frame_.points.begin(), frame_.points.end(), kNoPoint));
  }

  Map map_{SmallExtractor().scales()};
  const KeyframeId keyframe_;
  FrameInWork frame_{SquaresFeatures(1)};
};

TEST_F(LocalPointsTest, CollectsThePointsOfKeyframesThatShareSome) {
  const KeyframeId other = AddKeyframeWithPoints(map_, SquaresFeatures(2), Rigid3d::Identity());
  const std::vector<PointId>& known = map_.FindKeyframe(other)->points;
  frame_.points[0] = known[0];
  const std::vector<PointId> points = CollectLocalPoints(map_, 60, frame_);
  EXPECT_EQ(frame_.reference, other);
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end()));
  EXPECT_TRUE(std::binary_search(points.begin(), points.end(), known[5]));
  EXPECT_FALSE(
      std::binary_search(points.begin(), points.end(), map_.FindKeyframe(keyframe_)->points[5]));
}

TEST_F(LocalPointsTest, FindsPointsWhereThePoseExpectsThem) {
  Match();
  const auto features = static_cast<int>(frame_.features->size());
  EXPECT_GT(Matched(), 0.9 * features);  // some squares look like their neighbours
  const std::vector<PointId>& known = map_.FindKeyframe(keyframe_)->points;
  for (int i = 0; i < features; ++i) {
    if (frame_.points[i] == kNoPoint) continue;
    EXPECT_EQ(frame_.points[i], known[i]) << i;
  }
  EXPECT_EQ(map_.FindPoint(known[0])->visible, 2);
}

TEST_F(LocalPointsTest, WhatMovesIsNotMatched) {
  frame_.moves.assign(frame_.moves.size(), true);
  Match();
  EXPECT_EQ(Matched(), 0);
}

TEST_F(LocalPointsTest, CountsNothingIfTheMapIsToStayAsItIs) {
  Match(false);
  EXPECT_EQ(map_.FindPoint(map_.FindKeyframe(keyframe_)->points[0])->visible, 1);
}

}  // namespace
}  // namespace semantic_slam
