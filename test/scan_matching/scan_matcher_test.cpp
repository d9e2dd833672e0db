#include "semantic_slam/scan_matching/scan_matcher.h"

#include <gtest/gtest.h>

#include "matching_fixture.h"

namespace semantic_slam {
namespace {

const Rigid2d kTruth = MakeRigid2d({0.3, -0.2}, 0.4);

TEST(ScanMatcherTest, FitsToAFractionOfACellFromAfar) {
  const PlanarWorld room = PlanarRoom();
  CorrelativeMatcherOptions wide;
  wide.linear_window_m = 0.3;
  wide.translation_sigma_m = 0.3;
  CeresMatcherOptions loose;
  loose.translation_weight_per_m = 1.0;
  loose.rotation_weight_per_rad = 2.0;
  const ScanMatcher matcher({}, wide, loose);
  const auto match = matcher.Match(HitPoints(LaserScan(room, kTruth)), GridOf(room),
                                   kTruth * MakeRigid2d({0.15, -0.12}, 0.02));
  ASSERT_TRUE(match);
  // As near as Ceres comes from nearby (half a cell's diagonal, and its turn at 3 m), four cells
  // away as it is.
  EXPECT_LT(DistanceBetween(match->T_grid_scan, kTruth), 0.035);
  EXPECT_LT(AngleBetween(match->T_grid_scan, kTruth), 0.012);
}

TEST(ScanMatcherTest, DoesNotBelieveABadFit) {
  const PlanarPoints points = HitPoints(LaserScan(PlanarCorridor(), MakeRigid2d({0.0, 0.4}, 0.7)));
  EXPECT_FALSE(ScanMatcher({}, {}, {}).Match(points, GridOf(PlanarRoom()), kTruth));
}

TEST(ScanMatcherTest, WantsEnoughPoints) {
  const PlanarWorld room = PlanarRoom();
  PlanarPoints points = HitPoints(LaserScan(room, kTruth));
  points.resize(ScanMatcherOptions().min_points - 1);
  EXPECT_FALSE(ScanMatcher({}, {}, {}).Match(points, GridOf(room), kTruth));
  EXPECT_FALSE(ScanMatcher({}, {}, {}).Match({}, GridOf(room), kTruth));
}

TEST(ScanMatcherTest, GivesTheSameAnswerTwice) {
  const PlanarWorld room = PlanarRoom();
  const ProbabilityGrid grid = GridOf(room);
  const PlanarPoints points = HitPoints(LaserScan(room, kTruth));
  const Rigid2d expected = kTruth * MakeRigid2d({0.05, 0.02}, -0.03);
  const ScanMatcher matcher({}, {}, {});
  const auto first = matcher.Match(points, grid, expected);
  const auto second = matcher.Match(points, grid, expected);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->T_grid_scan.matrix(), second->T_grid_scan.matrix()) << "to the last bit";
}

}  // namespace
}  // namespace semantic_slam
