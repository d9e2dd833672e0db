#include "semantic_slam/ground_truth/grid_score.h"

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/ground_truth/floor_plan_truth.h"

namespace semantic_slam {
namespace {

const Rigid2d kSame = Rigid2d::Identity();

OccupancyMap Truth() {
  return TrueFloorPlan(SmallWorld(), {});
}

// Three rows of ten cells of 0.1 m: unknown but for the middle one, which is free with one occupied
// cell.
OccupancyMap Corridor(int occupied_x) {
  OccupancyMap map;
  map.resolution_m = 0.1;
  map.width = 10;
  map.height = 3;
  map.cells.assign(30, OccupancyMap::kUnknown);
  std::fill(map.cells.begin() + 10, map.cells.begin() + 20, std::int8_t{0});
  map.cells[10 + occupied_x] = 100;
  return map;
}

GridScoreOptions Strict() {
  GridScoreOptions options;
  options.tolerance_m = 0.0;
  return options;
}

TEST(GridScoreTest, APerfectGridIsRightEverywhere) {
  const GridScore score = ScoreGrid(Truth(), Truth(), kSame, Strict());
  EXPECT_GT(score.free_precision.cells, 1000u);
  EXPECT_EQ(score.free_precision.share(), 1.0);
  EXPECT_EQ(score.occupied_precision.share(), 1.0);
  EXPECT_EQ(score.free_recall.share(), 1.0);
  EXPECT_GT(score.occupied_recall.cells, 100u);
  EXPECT_EQ(score.occupied_recall.share(), 1.0);
}

TEST(GridScoreTest, CountsWhatIsWrongCellByCell) {
  const GridScore score = ScoreGrid(Corridor(3), Corridor(6), kSame, Strict());
  EXPECT_EQ(score.free_precision.cells, 9u);
  EXPECT_EQ(score.free_precision.right, 8u);
  EXPECT_EQ(score.occupied_precision.cells, 1u);
  EXPECT_EQ(score.occupied_precision.right, 0u);
  EXPECT_EQ(score.free_recall.cells, 9u);
  EXPECT_EQ(score.free_recall.right, 8u);
  EXPECT_EQ(score.occupied_recall.cells, 1u);
  EXPECT_EQ(score.occupied_recall.right, 0u);
}

TEST(GridScoreTest, ACellBesideTheRightOneIsRightWithinTheTolerance) {
  GridScoreOptions options;
  options.tolerance_m = 0.1;
  const GridScore near = ScoreGrid(Corridor(3), Corridor(4), kSame, options);
  EXPECT_EQ(near.occupied_precision.share(), 1.0);
  EXPECT_EQ(near.occupied_recall.share(), 1.0);
  const GridScore far = ScoreGrid(Corridor(3), Corridor(5), kSame, options);
  EXPECT_EQ(far.occupied_precision.share(), 0.0);
}

TEST(GridScoreTest, WhatWasNotSeenDoesNotCount) {
  OccupancyMap half = Truth();
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width / 2; ++x)
      half.cells[y * half.width + x] = OccupancyMap::kUnknown;
  }
  const GridScore score = ScoreGrid(Truth(), half, kSame, Strict());
  EXPECT_EQ(score.free_recall.share(), 1.0);
  EXPECT_EQ(score.occupied_recall.share(), 1.0);
  const GridScore all = ScoreGrid(Truth(), Truth(), kSame, Strict());
  EXPECT_LT(score.free_recall.cells, 0.6 * all.free_recall.cells);
}

TEST(GridScoreTest, TheMapsPoseIsTakenOut) {
  OccupancyMap moved = Corridor(3);
  moved.origin_m << 5.0, 0.0;
  EXPECT_EQ(ScoreGrid(Corridor(3), moved, MakeRigid2d({-5.0, 0.0}, 0.0), Strict())
                .occupied_recall.share(),
            1.0);
  EXPECT_EQ(ScoreGrid(Corridor(3), moved, kSame, Strict()).occupied_recall.cells, 0u);
  // Turned by half a turn about the corridor's middle.
  const GridScore turned =
      ScoreGrid(Corridor(3), Corridor(6), MakeRigid2d({1.0, 0.3}, M_PI), Strict());
  EXPECT_EQ(turned.occupied_precision.share(), 1.0);
}

TEST(GridScoreTest, AreaOfATableThatAGridMarks) {
  const std::vector<ConvexPolygon> table{{{1.4, 1.1}, {2.6, 1.1}, {2.6, 1.9}, {1.4, 1.9}}};
  EXPECT_EQ(OccupiedArea(table, Truth(), kSame, 0.05).share(), 1.0);
  FloorPlanOptions legs;
  legs.min_height_m = 0.2;
  legs.max_height_m = 0.5;
  const CellCount below = OccupiedArea(table, TrueFloorPlan(SmallWorld(), legs), kSame, 0.05);
  EXPECT_NEAR(below.cells * 0.05 * 0.05, 1.2 * 0.8, 0.01);
  EXPECT_LT(below.share(), 0.05);
  EXPECT_GT(below.share(), 0.005);
}

TEST(GridScoreTest, APolygonIsFilled) {
  OccupancyMap map = Corridor(0);
  FillPolygon({{0.5, 0.0}, {0.8, 0.0}, {0.8, 0.3}, {0.5, 0.3}}, map);
  EXPECT_EQ(std::count(map.cells.begin(), map.cells.end(), 100), 1 + 9);
  EXPECT_EQ(map.cells[5], 100);
  EXPECT_EQ(map.cells[8], OccupancyMap::kUnknown);
}

TEST(GridScoreTest, EmptyGridsHaveNothingToBeWrong) {
  EXPECT_EQ(ScoreGrid(Truth(), {}, kSame).free_precision.cells, 0u);
  EXPECT_EQ(ScoreGrid({}, Truth(), kSame).free_precision.share(), 1.0);
  EXPECT_EQ(OccupiedArea({{}}, Truth(), kSame, 0.05).cells, 0u);
}

TEST(GridScoreTest, RefusesOptionsOutOfRange) {
  GridScoreOptions options;
  options.free_percent = 80;
  EXPECT_THROW(ScoreGrid(Truth(), Truth(), kSame, options), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
