#include "semantic_slam/scan_matching/probability_grid.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kResolutionM = 0.1;
constexpr double kStep = 1e-3;  // a thousandth of a log-odds unit changes a probability by less

ProbabilityGrid GridWith(const CellBox& box) {
  ProbabilityGrid grid(kResolutionM);
  grid.Grow(box);
  return grid;
}

TEST(ProbabilityGridTest, KnowsNothingAtFirst) {
  const ProbabilityGrid grid = GridWith({{0, 0}, {4, 4}});
  EXPECT_EQ(grid.At({1, 1}), ProbabilityGrid::kUnknown);
  EXPECT_EQ(grid.At({1000, -1000}), ProbabilityGrid::kUnknown) << "outside";
  EXPECT_EQ(ProbabilityGrid::ToProbability(ProbabilityGrid::kUnknown), 0.5);
  EXPECT_TRUE(grid.KnownBox().empty());
  EXPECT_EQ(ProbabilityGrid(kResolutionM).At({0, 0}), ProbabilityGrid::kUnknown) << "no cells yet";
}

TEST(ProbabilityGridTest, ConvertsProbabilities) {
  for (const double p : {0.03, 0.45, 0.5, 0.62, 0.97}) {
    EXPECT_NEAR(ProbabilityGrid::ToProbability(ProbabilityGrid::FromProbability(p)), p, kStep);
  }
}

TEST(ProbabilityGridTest, MultipliesOdds) {
  ProbabilityGrid grid = GridWith({{0, 0}, {1, 1}});
  grid.Add({0, 0}, ProbabilityGrid::FromProbability(0.6));
  EXPECT_NEAR(ProbabilityGrid::ToProbability(grid.At({0, 0})), 0.6, kStep);
  grid.Add({0, 0}, ProbabilityGrid::FromProbability(0.75));
  // Odds of 3 : 2 times 3 : 1 are 9 : 2.
  EXPECT_NEAR(ProbabilityGrid::ToProbability(grid.At({0, 0})), 9.0 / 11.0, kStep);
}

TEST(ProbabilityGridTest, StaysOpenToOtherEvidence) {
  ProbabilityGrid grid = GridWith({{0, 0}, {1, 1}});
  const auto hit = ProbabilityGrid::FromProbability(0.9);
  for (int i = 0; i < 1000; ++i) grid.Add({0, 0}, hit);
  EXPECT_NEAR(ProbabilityGrid::ToProbability(grid.At({0, 0})), 0.98, kStep);
  for (int i = 0; i < 4; ++i) grid.Add({0, 0}, static_cast<ProbabilityGrid::LogOdds>(-hit));
  EXPECT_LT(ProbabilityGrid::ToProbability(grid.At({0, 0})), 0.5) << "odds 49 : 1 against 9^4 : 1";
}

TEST(ProbabilityGridTest, PutsPointsIntoCells) {
  const ProbabilityGrid grid(kResolutionM);
  EXPECT_EQ(grid.CellAt({0.05, 0.05}), CellIndex(0, 0));
  EXPECT_EQ(grid.CellAt({-0.05, 0.25}), CellIndex(-1, 2));
  EXPECT_TRUE(grid.CentreOf({-1, 2}).isApprox(Eigen::Vector2d(-0.05, 0.25), 1e-12));
}

TEST(ProbabilityGridTest, KeepsItsCellsWhenItGrows) {
  ProbabilityGrid grid = GridWith({{0, 0}, {3, 2}});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      grid.Add({x, y}, static_cast<ProbabilityGrid::LogOdds>(10 * y + x + 1));
    }
  }
  grid.Grow({{-200, -3}, {-199, 300}});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) EXPECT_EQ(grid.At({x, y}), 10 * y + x + 1);
  }
  EXPECT_EQ(grid.At({-200, 299}), ProbabilityGrid::kUnknown);
  EXPECT_TRUE(grid.box().Contains({-200, 299}));
  EXPECT_EQ(grid.KnownBox().low, CellIndex(0, 0));
  EXPECT_EQ(grid.KnownBox().high, CellIndex(3, 2));
}

TEST(ProbabilityGridTest, StaysAsItIsWhenThereIsRoom) {
  ProbabilityGrid grid = GridWith({{0, 0}, {10, 10}});
  const CellBox before = grid.box();
  grid.Grow({{2, 2}, {10, 10}});
  grid.Grow(CellBox());
  EXPECT_EQ(grid.box().low, before.low);
  EXPECT_EQ(grid.box().high, before.high);
}

TEST(CellBoxTest, IncludesCells) {
  CellBox box;
  EXPECT_TRUE(box.empty());
  EXPECT_FALSE(box.Contains({0, 0}));
  box.Include({-2, 5});
  EXPECT_EQ(box.width(), 1);
  box.Include({1, 4});
  EXPECT_EQ(box.width(), 4);
  EXPECT_EQ(box.height(), 2);
  EXPECT_TRUE(box.Contains({1, 5}));
  EXPECT_FALSE(box.Contains({2, 5}));
}

}  // namespace
}  // namespace semantic_slam
