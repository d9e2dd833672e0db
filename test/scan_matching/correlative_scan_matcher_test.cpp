#include "semantic_slam/scan_matching/correlative_scan_matcher.h"

#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "matching_fixture.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

const Rigid2d kTruth = MakeRigid2d({0.3, -0.2}, 0.4);

CorrelativeMatcherOptions WideWindow() {
  CorrelativeMatcherOptions options;
  options.linear_window_m = 0.3;
  options.angular_window_deg = 15.0;
  options.translation_sigma_m = 0.3;
  options.rotation_sigma_deg = 15.0;
  return options;
}

TEST(CorrelativeScanMatcherTest, RecoversKnownOffsets) {
  const PlanarWorld room = PlanarRoom();
  const ProbabilityGrid grid = GridOf(room);
  const CorrelativeScanMatcher matcher(WideWindow());
  const PlanarPoints points = HitPoints(LaserScan(room, kTruth));
  for (const auto& [x, y, yaw] : {std::tuple{0.0, 0.0, 0.0}, std::tuple{0.2, -0.1, 0.1},
                                  std::tuple{-0.25, 0.25, -0.2}, std::tuple{0.0, 0.3, 0.2}}) {
    const auto match = matcher.Match(points, grid, kTruth * MakeRigid2d({x, y}, yaw));
    ASSERT_TRUE(match);
    // As coarse as the grid: a cell's diagonal, and the turn that moves the farthest hit by a cell.
    EXPECT_LT(DistanceBetween(match->T_grid_scan, kTruth), 0.071);
    EXPECT_LT(AngleBetween(match->T_grid_scan, kTruth), 0.02);
    EXPECT_GT(match->score, 0.5);
  }
}

TEST(CorrelativeScanMatcherTest, DoesNotSlideAlongACorridor) {
  const PlanarWorld corridor = PlanarCorridor();
  const ProbabilityGrid grid = GridOf(corridor);
  const Rigid2d expected = MakeRigid2d({0.1, 0.1}, 0.05);
  const auto match =
      CorrelativeScanMatcher(WideWindow())
          .Match(HitPoints(LaserScan(corridor, MakeRigid2d({0.1, 0.0}, 0.0))), grid, expected);
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->T_grid_scan.translation().x(), 0.1, 0.051) << "nothing says otherwise: a cell";
  EXPECT_NEAR(match->T_grid_scan.translation().y(), 0.0, 0.051) << "across it is well known";
}

TEST(CorrelativeScanMatcherTest, StaysInItsWindow) {
  const PlanarWorld room = PlanarRoom();
  const ProbabilityGrid grid = GridOf(room);
  CorrelativeMatcherOptions options = WideWindow();
  options.linear_window_m = 0.1;
  options.angular_window_deg = 2.0;
  const Rigid2d expected = kTruth * MakeRigid2d({0.4, 0.0}, 0.2);
  const auto match =
      CorrelativeScanMatcher(options).Match(HitPoints(LaserScan(room, kTruth)), grid, expected);
  ASSERT_TRUE(match);
  EXPECT_LT(DistanceBetween(match->T_grid_scan, expected), 0.1 * std::sqrt(2.0) + 1e-9);
  EXPECT_LT(AngleBetween(match->T_grid_scan, expected), 2.0 * M_PI / 180.0 + 1e-9);
}

TEST(CorrelativeScanMatcherTest, StaysWhereItIsExpectedInAnEmptyGrid) {
  const PlanarPoints points = HitPoints(LaserScan(PlanarRoom(), kTruth));
  const auto match = CorrelativeScanMatcher().Match(points, ProbabilityGrid(0.05), kTruth);
  ASSERT_TRUE(match);
  EXPECT_TRUE(match->T_grid_scan.isApprox(kTruth, 1e-12));
  EXPECT_LT(match->score, 0.05) << "and says that it does not fit";
}

TEST(CorrelativeScanMatcherTest, HasNoAnswerToAnEmptyScan) {
  EXPECT_FALSE(CorrelativeScanMatcher().Match({}, GridOf(PlanarRoom()), kTruth));
}

TEST(CorrelativeScanMatcherTest, RefusesASigmaOfZero) {
  CorrelativeMatcherOptions options;
  options.translation_sigma_m = 0.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { CorrelativeScanMatcher{options}; }),
            "translation_sigma_m = 0, but must be in [0.001, 100]");
}

}  // namespace
}  // namespace semantic_slam
