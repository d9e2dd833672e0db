#include "semantic_slam/loop_closing/loop_detector.h"

#include <gtest/gtest.h>

#include "loop_closing/two_visits.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

class LoopDetectorTest : public testing::Test {
 protected:
  std::optional<Loop> Detect(KeyframeId keyframe,
                             const LoopDetectorOptions& options = LoopDetectorOptions()) const {
    return LoopDetector(options, visits_.index, visits_.map).Detect(keyframe, *SmallCamera());
  }

  TwoVisits visits_;
};

TEST_F(LoopDetectorTest, RecognisesThePlaceAndSaysWhereTheCameraIs) {
  const auto loop = Detect(TwoVisits::kLast);
  ASSERT_TRUE(loop);
  EXPECT_EQ(loop->keyframe, TwoVisits::kLast);
  EXPECT_LT(loop->place, TwoVisits::kVisit);
  // As good as tracking without noise: a pixel of this camera is 8 mm at 2 m.
  EXPECT_LT(DistanceBetween(loop->T_map_keyframe, TwoVisits::TruePose(TwoVisits::kAll - 1)), 0.01);
  EXPECT_LT(AngleBetween(loop->T_map_keyframe, TwoVisits::TruePose(TwoVisits::kAll - 1)), 0.01);
}

TEST_F(LoopDetectorTest, ThePointsAreTheFirstVisits) {
  const auto loop = Detect(TwoVisits::kLast);
  ASSERT_TRUE(loop);
  int points = 0;
  for (const PointId id : loop->points) {
    if (id == kNoPoint) continue;
    ++points;
    EXPECT_LT(visits_.map.FindPoint(id)->observations.front().keyframe, TwoVisits::kVisit);
  }
  EXPECT_GE(points, LoopDetectorOptions().min_inliers);
}

TEST_F(LoopDetectorTest, WhereTheCameraHasNotBeenThereIsNoLoop) {
  for (KeyframeId id = TwoVisits::kVisit; id < TwoVisits::kVisit + TwoVisits::kAway; ++id) {
    EXPECT_FALSE(Detect(id)) << id;
  }
}

TEST_F(LoopDetectorTest, AKeyframeAloneIsNotBelieved) {
  // The first image of the second visit has no neighbour yet that could confirm it.
  TwoVisits visits;
  const KeyframeId first = TwoVisits::kVisit + TwoVisits::kAway;
  Map& map = visits.map;
  for (KeyframeId id = TwoVisits::kLast; id > first; --id) map.CullKeyframe(id);
  EXPECT_FALSE(LoopDetector(LoopDetectorOptions(), visits.index, map).Detect(first, *SmallCamera()));
}

TEST_F(LoopDetectorTest, AGoneKeyframeIsNoError) {
  EXPECT_FALSE(Detect(999));
}

TEST_F(LoopDetectorTest, RefusesOptionsByName) {
  LoopDetectorOptions options;
  options.min_inliers = 0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { Detect(0, options); }).substr(0, 15), "min_inliers = 0");
}

}  // namespace
}  // namespace semantic_slam
