#include "semantic_slam/loop_closing/full_adjuster.h"

#include <gtest/gtest.h>

#include "loop_closing/two_visits.h"

namespace semantic_slam {
namespace {

TEST(FullAdjusterTest, PutsKeyframesAndPointsWhereTheyBelong) {
  TwoVisits visits;
  FullAdjuster adjuster(FullAdjusterOptions(), visits.map);
  Keyframe& moved = *visits.map.FindKeyframe(2);
  moved.T_map_camera = Nudged(moved.T_map_camera, 0.02, 0.01, 5);
  FullAdjuster::Work work = adjuster.Copy();
  adjuster.Solve(work, *SmallCamera());
  adjuster.Apply(work);
  // As good as tracking without noise: a pixel of this camera is 8 mm at 2 m.
  EXPECT_LT(visits.Error(2), 0.01);
  EXPECT_LT(visits.Error(0), 1e-12);  // holds the map in place
}

TEST(FullAdjusterTest, WhatWasAddedMeanwhileMovesAlong) {
  TwoVisits visits;
  FullAdjuster adjuster(FullAdjusterOptions(), visits.map);
  FullAdjuster::Work work = adjuster.Copy();
  const KeyframeId late =
      AddKeyframeWithPoints(visits.map, SquaresFeatures(7), visits.map.KeyframePose(TwoVisits::kLast));
  const Rigid3d target = Nudged(visits.map.KeyframePose(TwoVisits::kLast), 0.5, 0.2, 6);
  work.problem.cameras.back().T_map_camera = target;  // as if the solver had found this
  adjuster.Apply(work);
  EXPECT_EQ(visits.map.FindKeyframe(late)->parent, TwoVisits::kLast);
  EXPECT_LT(DistanceBetween(visits.map.KeyframePose(late), target), 1e-9);
}

TEST(FullAdjusterTest, ALargeMapIsLeftToThePoseGraph) {
  TwoVisits visits;
  FullAdjusterOptions options;
  options.max_keyframes = TwoVisits::kAll - 1;
  FullAdjuster adjuster(options, visits.map);
  FullAdjuster::Work work = adjuster.Copy();
  EXPECT_TRUE(work.keyframes.empty());
  const std::uint64_t before = visits.map.revision();
  adjuster.Solve(work, *SmallCamera());
  adjuster.Apply(work);
  EXPECT_EQ(visits.map.revision(), before);
}

TEST(FullAdjusterTest, AnotherMapIsNotTouched) {
  TwoVisits visits;
  FullAdjuster adjuster(FullAdjusterOptions(), visits.map);
  FullAdjuster::Work work = adjuster.Copy();
  visits.map.Clear();
  const std::uint64_t before = visits.map.revision();
  adjuster.Apply(work);
  EXPECT_EQ(visits.map.revision(), before);
}

}  // namespace
}  // namespace semantic_slam
