#include "semantic_slam_ros/grid_conversions.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "testing/expect_error.h"
#include "testing/small_vocabulary.h"

namespace semantic_slam_ros {
namespace {

using nav_msgs::OccupancyGrid;
using semantic_slam::ExpectOneLineWith;
using semantic_slam::InputError;
using semantic_slam::MessageOf;
using semantic_slam::OccupancyMap;
using semantic_slam::SemanticCells;
using semantic_slam::SmallVocabulary;
using GridMsg = semantic_slam::SemanticGrid;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr float kNanF = std::numeric_limits<float>::quiet_NaN();

OccupancyMap SomeMap() {
  OccupancyMap map;
  map.stamp = Stamp{1305031453359684001};
  map.resolution_m = 0.05;
  map.origin_m = {-1.5, 2.25};
  map.width = 3;
  map.height = 2;
  map.cells = {-1, 0, 50, 100, 99, 1};
  return map;
}

std::string MapError(const OccupancyGrid& msg) {
  return MessageOf<InputError>([&] { ToOccupancyMap(msg); });
}

TEST(OccupancyGridTest, ReadsBackWhatItWrites) {
  const OccupancyMap written = SomeMap();
  const OccupancyGrid msg = ToOccupancyGrid(written, "map");
  EXPECT_EQ(msg.header.frame_id, "map");
  EXPECT_EQ(msg.info.origin.orientation.w, 1.0);
  const OccupancyMap read = ToOccupancyMap(msg);
  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.resolution_m, 0.05) << "although the message has a float";
  EXPECT_EQ(read.origin_m, written.origin_m);
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.cells, written.cells);
}

TEST(OccupancyGridTest, AMapWithoutCellsIsNoFault) {
  OccupancyMap empty = SomeMap();
  empty.width = empty.height = 0;
  empty.cells.clear();
  EXPECT_TRUE(ToOccupancyMap(ToOccupancyGrid(empty, "map")).cells.empty());
}

TEST(OccupancyGridTest, RefusesWhatIsMalformed) {
  const OccupancyGrid good = ToOccupancyGrid(SomeMap(), "map");
  OccupancyGrid msg = good;
  msg.data.pop_back();
  EXPECT_EQ(MapError(msg), "map: data has 5 elements, expected 6");
  msg = good;
  msg.data[2] = 101;
  EXPECT_EQ(MapError(msg), "map: a cell is 101, expected -1 to 100");
  msg.data[2] = -2;
  EXPECT_EQ(MapError(msg), "map: a cell is -2, expected -1 to 100");
  for (const float resolution : {0.0f, -0.05f, kNanF}) {
    msg = good;
    msg.info.resolution = resolution;
    ExpectOneLineWith(MapError(msg), {"map: resolution is"});
  }
  msg = good;
  msg.info.width = 4000000000u;
  EXPECT_EQ(MapError(msg), "map: size is 4000000000 x 2 cells");
  msg = good;
  msg.info.origin.position.x = kNan;
  EXPECT_EQ(MapError(msg), "map: origin is not finite");
  msg = good;
  msg.info.origin.orientation.z = 0.1;
  EXPECT_EQ(MapError(msg), "map: origin is turned, which is not supported");
  msg.info.origin.orientation.z = kNan;
  EXPECT_EQ(MapError(msg), "map: origin is turned, which is not supported");
}

SemanticCells SomeCells() {
  SemanticCells cells;
  cells.stamp = Stamp{50};
  cells.map_id = 2;
  cells.revision = 9;
  cells.vocabulary_hash = SmallVocabulary().hash();
  cells.resolution_m = 0.1;
  cells.origin_m = {1.0, -2.0};
  cells.width = 2;
  cells.height = 1;
  cells.cost = {254, 255};
  cells.classes_per_cell = 2;
  cells.labels = {4, 3, 0, 0};
  cells.probabilities = {200, 30, 0, 0};
  cells.min_height_m = {0.5f, kNanF};
  cells.max_height_m = {0.75f, kNanF};
  return cells;
}

std::string GridError(const GridMsg& msg) {
  return MessageOf<InputError>([&] { ToSemanticCells(msg, SmallVocabulary()); });
}

TEST(SemanticGridTest, ReadsBackWhatItWrites) {
  const SemanticCells written = SomeCells();
  const SemanticCells read = ToSemanticCells(ToSemanticGrid(written, "map"), SmallVocabulary());
  EXPECT_EQ(read.stamp, written.stamp);
  EXPECT_EQ(read.map_id, 2);
  EXPECT_EQ(read.revision, 9u);
  EXPECT_EQ(read.vocabulary_hash, written.vocabulary_hash);
  EXPECT_EQ(read.resolution_m, 0.1);
  EXPECT_EQ(read.origin_m, written.origin_m);
  EXPECT_EQ(read.width, 2);
  EXPECT_EQ(read.height, 1);
  EXPECT_EQ(read.cost, written.cost);
  EXPECT_EQ(read.classes_per_cell, 2);
  EXPECT_EQ(read.labels, written.labels);
  EXPECT_EQ(read.probabilities, written.probabilities);
  EXPECT_EQ(read.min_height_m[0], 0.5f);
  EXPECT_TRUE(std::isnan(read.max_height_m[1]));
}

TEST(SemanticGridTest, RefusesWhatIsMalformed) {
  const std::vector<std::pair<std::function<void(GridMsg&)>, std::string>> faults{
      {[](GridMsg& m) { m.cost.pop_back(); }, "semantic grid: cost has 1 elements, expected 2"},
      {[](GridMsg& m) { m.labels.pop_back(); }, "semantic grid: labels has 3 elements, expected 4"},
      {[](GridMsg& m) { m.probabilities.clear(); },
       "semantic grid: probabilities has 0 elements, expected 4"},
      {[](GridMsg& m) { m.min_height.clear(); },
       "semantic grid: min_height has 0 elements, expected 2"},
      {[](GridMsg& m) { m.max_height.clear(); },
       "semantic grid: max_height has 0 elements, expected 2"},
      {[](GridMsg& m) { m.labels[1] = 8; }, "semantic grid: label id 8 is not in the vocabulary"},
      {[](GridMsg& m) { m.label_set_hash = 4; }, "semantic grid: made with another label set"},
      {[](GridMsg& m) { m.info.resolution = 0.0f; }, "semantic grid: resolution is 0.000000"}};
  const GridMsg good = ToSemanticGrid(SomeCells(), "map");
  EXPECT_EQ(GridError(good), "");
  for (const auto& [spoil, error] : faults) {
    GridMsg msg = good;
    spoil(msg);
    ExpectOneLineWith(GridError(msg), {error.c_str()});
  }
}

TEST(SemanticGridTest, TheCostAloneIsAnOccupancyGrid) {
  const OccupancyGrid msg = ToOccupancyGrid(SomeCells(), "map");
  EXPECT_EQ(msg.info.width, 2u);
  EXPECT_EQ(msg.info.origin.position.y, -2.0);
  EXPECT_EQ(msg.data, (std::vector<std::int8_t>{100, -1}));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
