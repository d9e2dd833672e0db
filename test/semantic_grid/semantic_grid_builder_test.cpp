#include "semantic_slam/semantic_grid/semantic_grid_builder.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "semantic_grid/small_plan.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr std::uint8_t kFree = SemanticCells::kFree;
constexpr std::uint8_t kLethal = SemanticCells::kLethal;
constexpr std::uint8_t kUnknown = SemanticCells::kUnknown;

SemanticGridBuilder Builder(SemanticGridOptions options = {}, double flight_height_m = 0.5) {
  SemanticCostOptions costs;
  costs.flight_min_height_m = costs.flight_max_height_m = flight_height_m;
  return {options, costs, SmallVocabulary()};
}

std::size_t Cell(const SemanticCells& cells, int x, int y) {
  return static_cast<std::size_t>(y) * cells.width + x;
}

int Count(const SemanticCells& cells, std::uint8_t cost) {
  return static_cast<int>(std::count(cells.cost.begin(), cells.cost.end(), cost));
}

TEST(SemanticGridBuilderTest, OccupancyAloneIsTheCost) {
  OccupancyMap map = FreePlan();
  map.cells[0] = 100;
  map.cells[1] = OccupancyMap::kUnknown;
  const SemanticCells cells = Builder().Build(map, ObjectMap());
  EXPECT_EQ(cells.width, 10);
  EXPECT_EQ(cells.height, 10);
  EXPECT_EQ(cells.resolution_m, 0.1);
  EXPECT_EQ(cells.origin_m, Eigen::Vector2d(0.0, 0.0));
  EXPECT_EQ(cells.cost[0], kLethal);
  EXPECT_EQ(cells.cost[1], kUnknown);
  EXPECT_EQ(Count(cells, kFree), 98);
  EXPECT_EQ(cells.probabilities, std::vector<std::uint8_t>(300, 0));
  EXPECT_TRUE(std::isnan(cells.min_height_m[0])) << "the floor plan does not tell heights";
  EXPECT_EQ(cells.stamp, Stamp{5});
  EXPECT_EQ(cells.map_id, 1);
  EXPECT_EQ(cells.revision, 3u);
}

// Thesis section 3.4.3: the map shows four legs, the robot must not fly between them.
TEST(SemanticGridBuilderTest, ATableOfWhichTheMapShowsTheLegsBecomesAnArea) {
  OccupancyMap map = FreePlan();
  for (const int leg : {32, 35, 42, 45}) map.cells[leg] = 100;
  const SemanticCells cells = Builder().Build(map, ObjectMapOf({SmallTable()}));
  EXPECT_EQ(Count(cells, kLethal), 8) << "4 x 2 cells";
  for (int y = 3; y < 5; ++y) {
    for (int x = 2; x < 6; ++x) {
      const std::size_t cell = Cell(cells, x, y);
      EXPECT_EQ(cells.cost[cell], kLethal) << x << ", " << y;
      EXPECT_EQ(cells.labels[3 * cell], 4);
      EXPECT_EQ(cells.probabilities[3 * cell], 255);
      EXPECT_EQ(cells.min_height_m[cell], 0.0f);
      EXPECT_EQ(cells.max_height_m[cell], 0.7f);
    }
  }
  EXPECT_EQ(Count(cells, kFree), 92);
  EXPECT_EQ(cells.stamp, Stamp{7});
  EXPECT_EQ(cells.map_id, 2);
  EXPECT_EQ(cells.revision, 9u);
}

TEST(SemanticGridBuilderTest, ARobotThatFliesOverTheTableSeesItWithoutCost) {
  const SemanticCells over = Builder({}, 0.85).Build(FreePlan(), ObjectMapOf({SmallTable()}));
  EXPECT_EQ(Count(over, kFree), 100);
  EXPECT_EQ(over.labels[3 * Cell(over, 3, 3)], 4);
  EXPECT_EQ(over.max_height_m[Cell(over, 3, 3)], 0.7f);
  const SemanticCells too_low = Builder({}, 0.75).Build(FreePlan(), ObjectMapOf({SmallTable()}));
  EXPECT_EQ(Count(too_low, kLethal), 8) << "the margin is 0.1 m";
}

TEST(SemanticGridBuilderTest, AClassWithoutCostNeverRaisesIt) {
  MapObject mat = SmallTable();
  mat.labels = {{2, 1.0f}};
  const SemanticCells cells = Builder().Build(FreePlan(), ObjectMapOf({mat}));
  EXPECT_EQ(Count(cells, kFree), 100);
  EXPECT_EQ(cells.labels[3 * Cell(cells, 3, 3)], 2);
}

TEST(SemanticGridBuilderTest, ACheaperClassCostsLess) {
  MapObject chair = SmallTable();
  chair.labels = {{3, 0.75f}};
  const SemanticCells cells = Builder().Build(FreePlan(), ObjectMapOf({chair}));
  EXPECT_EQ(Count(cells, 100), 8);
  EXPECT_EQ(cells.probabilities[3 * Cell(cells, 3, 3)], 191) << "floor(255 * 0.75)";
}

TEST(SemanticGridBuilderTest, HeightsSpanWhatStandsInTheCell) {
  MapObject lamp = SmallTable();
  lamp.id = 2;
  lamp.labels = {{9, 1.0f}};
  lamp.footprint_m = {{0.2, 0.3}, {0.3, 0.3}, {0.3, 0.4}, {0.2, 0.4}};
  lamp.min_height_m = 0.7;
  lamp.max_height_m = 1.1;
  const SemanticCells cells = Builder().Build(FreePlan(), ObjectMapOf({SmallTable(), lamp}));
  const std::size_t both = Cell(cells, 2, 3), table_only = Cell(cells, 3, 3);
  EXPECT_EQ(cells.min_height_m[both], 0.0f);
  EXPECT_EQ(cells.max_height_m[both], 1.1f);
  EXPECT_EQ(cells.max_height_m[table_only], 0.7f);
  EXPECT_EQ(cells.cost[both], kLethal) << "the lamp's 50 does not lower it";
}

TEST(SemanticGridBuilderTest, GrowsInWholeCellsSoThatAllFits) {
  MapObject table = SmallTable();
  for (Eigen::Vector2d& corner : table.footprint_m) corner -= Eigen::Vector2d(1.0, 0.0);
  const SemanticCells cells = Builder().Build(FreePlan(), ObjectMapOf({table}));
  EXPECT_EQ(cells.width, 18) << "from -0.8 to 1.0 m";
  EXPECT_EQ(cells.height, 10);
  // 1e-12: eight times 0.1.
  EXPECT_NEAR(cells.origin_m.x(), -0.8, 1e-12);
  EXPECT_EQ(cells.origin_m.y(), 0.0);
  EXPECT_EQ(cells.cost[Cell(cells, 0, 3)], kLethal) << "a sure object in a place never seen";
  EXPECT_EQ(cells.cost[Cell(cells, 0, 2)], kUnknown);
  EXPECT_EQ(cells.cost[Cell(cells, 8, 0)], kFree) << "the map's first cell";
  EXPECT_EQ(Count(cells, kFree), 100);
}

TEST(SemanticGridBuilderTest, WorksWithoutAMap) {
  SemanticGridOptions options;
  options.resolution_m = 0.1;
  const SemanticCells cells = Builder(options).Build(OccupancyMap(), ObjectMapOf({SmallTable()}));
  EXPECT_EQ(cells.width, 4);
  EXPECT_EQ(cells.height, 2);
  EXPECT_EQ(Count(cells, kLethal), 8);
  // 1e-12: two times 0.1.
  EXPECT_NEAR(cells.origin_m.x(), 0.2, 1e-12);
}

TEST(SemanticGridBuilderTest, NothingAtAllIsAnEmptyGrid) {
  const SemanticCells cells = Builder().Build(OccupancyMap(), ObjectMap());
  EXPECT_EQ(cells.width, 0);
  EXPECT_EQ(cells.height, 0);
  EXPECT_TRUE(cells.cost.empty());
}

TEST(SemanticGridBuilderTest, AnUncertainPositionBlursWithABound) {
  MapObject table = SmallTable();
  table.footprint_m = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  table.position_covariance_m2 = Eigen::Matrix3d::Identity();  // a metre
  SemanticGridOptions options;
  options.max_position_sigma_m = 0.1;
  const SemanticCells cells = Builder(options).Build(FreePlan(), ObjectMapOf({table}));
  EXPECT_EQ(cells.width, 16) << "three standard deviations to either side";
  EXPECT_EQ(cells.cost[Cell(cells, 8, 8)], kLethal) << "the middle is sure";
  const auto probability = [&](int x) { return cells.probabilities[3 * Cell(cells, x, 8)]; };
  EXPECT_GT(probability(3), probability(2)) << "inside and outside the edge";
  EXPECT_GT(probability(2), 0);
  EXPECT_EQ(cells.cost[Cell(cells, 1, 8)], kUnknown) << "a slight chance tells nothing";
}

TEST(SemanticGridBuilderTest, AnObjectWithoutFootprintCoversItsBox) {
  MapObject table = SmallTable();
  table.footprint_m.clear();
  EXPECT_EQ(Count(Builder().Build(FreePlan(), ObjectMapOf({table})), kLethal), 8);
  table.footprint_m = {{0.2, 0.3}, {0.6, 0.3}};  // a line has no area
  EXPECT_EQ(Count(Builder().Build(FreePlan(), ObjectMapOf({table})), kLethal), 8);
  table.box_size_m = {0.4, 0.0, 0.7};
  EXPECT_EQ(Count(Builder().Build(FreePlan(), ObjectMapOf({table})), kLethal), 0);
}

TEST(SemanticGridBuilderTest, LeavesOutWhatWouldMakeTheGridTooLong) {
  SemanticGridOptions options;
  options.max_side_m = 2.0;
  MapObject far = SmallTable(), farther = SmallTable();
  for (Eigen::Vector2d& corner : far.footprint_m) corner.x() += 1.2;
  for (Eigen::Vector2d& corner : farther.footprint_m) corner.x() += 1e12;
  const SemanticCells cells = Builder(options).Build(FreePlan(), ObjectMapOf({far, farther}));
  EXPECT_EQ(cells.width, 18);
  for (Eigen::Vector2d& corner : far.footprint_m) corner.x() += 1.0;
  EXPECT_EQ(Builder(options).Build(FreePlan(), ObjectMapOf({far})).width, 10);
}

TEST(SemanticGridBuilderTest, TheSameInputGivesTheSameGrid) {
  const ObjectMap objects = ObjectMapOf({SmallTable()});
  const SemanticCells a = Builder().Build(FreePlan(), objects);
  const SemanticCells b = Builder().Build(FreePlan(), objects);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.probabilities, b.probabilities);
}

TEST(SemanticGridBuilderTest, RefusesInputThatDoesNotFit) {
  ObjectMap objects = ObjectMapOf({SmallTable()});
  objects.vocabulary_hash = 1;
  ExpectOneLineWith(MessageOf<InputError>([&] { Builder().Build(FreePlan(), objects); }),
                    {"another label set, hash 1"});
  OccupancyMap map = FreePlan();
  map.cells.pop_back();
  ExpectOneLineWith(MessageOf<InputError>([&] { Builder().Build(map, ObjectMap()); }),
                    {"an occupancy map of 10 x 10 has 99 cells"});
}

TEST(SemanticGridBuilderTest, RefusesOptionsOutOfRange) {
  SemanticGridOptions options;
  options.classes_per_cell = 0;
  EXPECT_THROW(Builder(options), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
