#include "semantic_slam/scan_matching/ceres_scan_matcher.h"

#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "matching_fixture.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

const Rigid2d kTruth = MakeRigid2d({0.3, -0.2}, 0.4);

TEST(CeresScanMatcherTest, FitsToAFractionOfACell) {
  const PlanarWorld room = PlanarRoom();
  const ProbabilityGrid grid = GridOf(room);
  const PlanarPoints points = HitPoints(LaserScan(room, kTruth));
  for (const auto& [x, y, yaw] : {std::tuple{0.0, 0.0, 0.0}, std::tuple{0.05, -0.03, 0.01},
                                  std::tuple{-0.04, 0.05, -0.015}}) {
    const Rigid2d start = kTruth * MakeRigid2d({x, y}, yaw);
    const auto match = CeresScanMatcher().Match(points, grid, start, start);
    ASSERT_TRUE(match);
    // Half a cell's diagonal: within their cells the walls may lie anywhere. 3 m away, where the
    // walls are, that is 12 mrad.
    EXPECT_LT(DistanceBetween(match->T_grid_scan, kTruth), 0.035);
    EXPECT_LT(AngleBetween(match->T_grid_scan, kTruth), 0.012);
    EXPECT_GT(match->score, 0.5);
  }
}

TEST(CeresScanMatcherTest, IsHeldByThePriors) {
  const PlanarWorld room = PlanarRoom();
  const ProbabilityGrid grid = GridOf(room);
  CeresMatcherOptions options;
  options.translation_weight_per_m = 1e3;
  options.rotation_weight_per_rad = 1e3;
  const Rigid2d expected = kTruth * MakeRigid2d({0.05, -0.03}, 0.01);
  const auto match =
      CeresScanMatcher(options).Match(HitPoints(LaserScan(room, kTruth)), grid, expected, kTruth);
  ASSERT_TRUE(match);
  EXPECT_LT(DistanceBetween(match->T_grid_scan, expected), 1e-3) << "a hair against such weights";
}

TEST(CeresScanMatcherTest, DoesNotSlideAlongACorridor) {
  const PlanarWorld corridor = PlanarCorridor();
  const ProbabilityGrid grid = GridOf(corridor);
  const PlanarPoints points = HitPoints(LaserScan(corridor, MakeRigid2d({0.1, 0.0}, 0.0)));
  const Rigid2d expected = MakeRigid2d({0.1, 0.05}, 0.01);
  const auto match = CeresScanMatcher().Match(points, grid, expected, expected);
  ASSERT_TRUE(match);
  // Rounding of the walls to cells leaves the farthest hits something to hold on to.
  EXPECT_NEAR(match->T_grid_scan.translation().x(), 0.1, 0.02);
  EXPECT_NEAR(match->T_grid_scan.translation().y(), 0.0, 0.035) << "half a cell, see above";
}

TEST(CeresScanMatcherTest, TakesTheShortWayAround) {
  const PlanarWorld room = PlanarRoom();
  const ProbabilityGrid grid = GridOf(room);
  const Rigid2d truth = MakeRigid2d({0.3, -0.2}, M_PI - 0.002);
  const Rigid2d expected = MakeRigid2d({0.3, -0.2}, -M_PI + 0.002);
  const auto match =
      CeresScanMatcher().Match(HitPoints(LaserScan(room, truth)), grid, expected, truth);
  ASSERT_TRUE(match);
  EXPECT_LT(AngleBetween(match->T_grid_scan, truth), 0.005);
}

TEST(CeresScanMatcherTest, StaysWhereItIsExpectedInAnEmptyGrid) {
  const PlanarPoints points = HitPoints(LaserScan(PlanarRoom(), kTruth));
  const auto match = CeresScanMatcher().Match(points, ProbabilityGrid(0.05), kTruth, kTruth);
  ASSERT_TRUE(match);
  EXPECT_LT(DistanceBetween(match->T_grid_scan, kTruth), 1e-9);
}

TEST(CeresScanMatcherTest, HasNoAnswerToAnEmptyScan) {
  EXPECT_FALSE(CeresScanMatcher().Match({}, GridOf(PlanarRoom()), kTruth, kTruth));
}

TEST(CeresScanMatcherTest, RefusesNoIterations) {
  CeresMatcherOptions options;
  options.iterations = 0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { CeresScanMatcher{options}; }),
            "iterations = 0, but must be in [1, 200]");
}

}  // namespace
}  // namespace semantic_slam
