#include "semantic_slam/scan_matching/scan_inserter.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr double kResolutionM = 0.1;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Beams ahead (along x) and to the left (along y).
PlanarScan TwoBeams(const ScanBeam& ahead, const ScanBeam& left) {
  PlanarScan scan;
  scan.bearing_step_rad = M_PI / 2;
  scan.beams = {ahead, left};
  return scan;
}

// The scanner in the middle of cell (0, 0).
Rigid2d InTheMiddle() {
  return MakeRigid2d({0.05, 0.05}, 0.0);
}

double ProbabilityAt(const ProbabilityGrid& grid, int x, int y) {
  return ProbabilityGrid::ToProbability(grid.At({x, y}));
}

std::vector<CellIndex> Traversed(const Eigen::Vector2d& begin, const Eigen::Vector2d& end) {
  std::vector<CellIndex> cells;
  TraverseCells(begin, end, [&](const CellIndex& cell) { cells.push_back(cell); });
  return cells;
}

TEST(ScanInserterTest, MarksWhereBeamsEndAndWhatTheyCross) {
  ProbabilityGrid grid(kResolutionM);
  ScanInserter().Insert(TwoBeams({0.5f, 0.0f, 0.5f}, {kNan, 0.0f, 0.3f}), InTheMiddle(), grid);
  EXPECT_GT(ProbabilityAt(grid, 5, 0), 0.6);
  for (int x = 0; x < 5; ++x) EXPECT_LT(ProbabilityAt(grid, x, 0), 0.5);
  for (int y = 1; y <= 3; ++y) EXPECT_LT(ProbabilityAt(grid, 0, y), 0.5);
  EXPECT_EQ(grid.At({6, 0}), ProbabilityGrid::kUnknown) << "behind the hit";
  EXPECT_EQ(grid.At({0, 4}), ProbabilityGrid::kUnknown) << "beyond what is free";
}

TEST(ScanInserterTest, ClearsOnlyWhatWasSeenFree) {
  ProbabilityGrid grid(kResolutionM);
  ScanInserter().Insert(TwoBeams({1.0f, 0.5f, 0.7f}, {}), InTheMiddle(), grid);
  EXPECT_GT(ProbabilityAt(grid, 10, 0), 0.5);
  EXPECT_LT(ProbabilityAt(grid, 6, 0), 0.5);
  for (const int x : {0, 3, 9}) EXPECT_EQ(grid.At({x, 0}), ProbabilityGrid::kUnknown);
}

TEST(ScanInserterTest, PlacesTheScanByItsPose) {
  ProbabilityGrid grid(kResolutionM);
  ScanInserter().Insert(TwoBeams({0.5f, 0.0f, 0.5f}, {}), MakeRigid2d({1.05, 2.05}, M_PI / 2),
                        grid);
  EXPECT_GT(ProbabilityAt(grid, 10, 25), 0.6);
}

TEST(ScanInserterTest, UpdatesEachCellOncePerScan) {
  // A hundred beams through the same cells, half of them ending in one.
  PlanarScan scan;
  scan.bearing_step_rad = 1e-6;
  for (int i = 0; i < 100; ++i) {
    const float hit_m = i % 2 == 0 ? 0.5f : 0.8f;
    scan.beams.push_back({hit_m, 0.0f, hit_m});
  }
  ProbabilityGrid grid(kResolutionM);
  const ScanInserterOptions options;
  ScanInserter(options).Insert(scan, InTheMiddle(), grid);
  // A thousandth of a log-odds unit changes a probability by less than this.
  EXPECT_NEAR(ProbabilityAt(grid, 2, 0), options.miss_probability, 1e-3);
  EXPECT_NEAR(ProbabilityAt(grid, 5, 0), options.hit_probability, 1e-3) << "ended beats crossed";
}

TEST(ScanInserterTest, DoesNothingWithNothing) {
  ProbabilityGrid grid(kResolutionM);
  ScanInserter().Insert(PlanarScan(), InTheMiddle(), grid);
  ScanInserter().Insert(TwoBeams({}, {}), InTheMiddle(), grid);
  EXPECT_TRUE(grid.box().empty());
}

TEST(ScanInserterTest, RefusesAHitThatSpeaksAgainstAnObstacle) {
  ScanInserterOptions options;
  options.hit_probability = 0.4;
  EXPECT_EQ(MessageOf<ConfigError>([&] { ScanInserter{options}; }),
            "hit_probability = 0.4, but must be in [0.51, 0.95]");
}

TEST(TraverseCellsTest, CrossesNeighboursOnly) {
  const std::vector<CellIndex> cells = Traversed({0.5, 0.2}, {-3.3, 2.7});
  ASSERT_EQ(cells.size(), 1u + 4u + 2u) << "a step for each border crossed";
  EXPECT_EQ(cells.front(), CellIndex(0, 0));
  EXPECT_EQ(cells.back(), CellIndex(-4, 2));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    EXPECT_EQ((cells[i] - cells[i - 1]).cwiseAbs().sum(), 1);
  }
}

TEST(TraverseCellsTest, CrossesTheCellsThatTheLineDoes) {
  const std::vector<CellIndex> cells = Traversed({0.5, 0.5}, {2.5, 1.4});
  // The line reaches y = 1 at x = 1.61.
  const std::vector<CellIndex> expected{{0, 0}, {1, 0}, {1, 1}, {2, 1}};
  EXPECT_EQ(cells, expected);
}

TEST(TraverseCellsTest, StaysInItsCell) {
  EXPECT_EQ(Traversed({0.5, 0.5}, {0.5, 0.5}).size(), 1u);
  EXPECT_EQ(Traversed({0.1, 0.1}, {0.9, 0.9}).size(), 1u);
}

TEST(TraverseCellsTest, EndsOnBorders) {
  for (const Eigen::Vector2d& end : {Eigen::Vector2d(3.0, 3.0), Eigen::Vector2d(-2.0, 1.0),
                                     Eigen::Vector2d(0.0, 5.0), Eigen::Vector2d(7.0, 0.5)}) {
    EXPECT_EQ(Traversed({0.5, 0.5}, end).back(), CellIndex(end.x(), end.y()));
    EXPECT_EQ(Traversed(end, {0.5, 0.5}).back(), CellIndex(0, 0));
  }
}

}  // namespace
}  // namespace semantic_slam
