// Drives semantic_grid, as a node and as a nodelet (semantic_grid_node.test,
// semantic_grid_nodelet.test), over real topics.

#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <semantic_slam/SaveMap.h>
#include <semantic_slam/SemanticGrid.h>
#include <semantic_slam/SemanticObjectArray.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/Trigger.h>

#include "ros/ros_testing.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam_ros/grid_conversions.h"
#include "semantic_slam_ros/object_conversions.h"
#include "testing/temporary_folder.h"

namespace semantic_slam_ros {
namespace {

using nav_msgs::OccupancyGrid;
using semantic_slam::LabelVocabulary;
using GridMsg = semantic_slam::SemanticGrid;
using ObjectArrayMsg = semantic_slam::SemanticObjectArray;

constexpr double kLimitS = 15.0;
constexpr int kCells = 40;  // per side of the room

class SemanticGridNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(SpinUntil(
        [&] {
          return grids_.connected() && maps_.connected() && map_pub_.getNumSubscribers() > 0 &&
                 objects_pub_.getNumSubscribers() > 0 && diagnostics_.last();
        },
        kLimitS))
        << "semantic_grid did not connect; is it running?";
    // Each test begins without a grid.
    std_srvs::Trigger reset;
    ASSERT_TRUE(ros::service::call("semantic_grid/reset", reset));
    EXPECT_TRUE(reset.response.success);
    ASSERT_TRUE(SpinUntil([&] { return grids_.last() && grids_.last()->cost.empty(); }, kLimitS));
    grids_.Forget();
    maps_.Forget();
  }

  // Free space of 4 x 4 m from (0, 0); stamps go on.
  static OccupancyGrid Room() {
    semantic_slam::OccupancyMap map;
    map.stamp = NextStamp();
    map.resolution_m = 0.1;
    map.width = map.height = kCells;
    map.cells.assign(kCells * kCells, 0);
    return ToOccupancyGrid(map, "map");
  }

  // A table of 1 x 1 m with a corner at (1, 1), at flight height.
  ObjectArrayMsg Table() const {
    semantic_slam::MapObject table;
    table.id = 3;
    table.labels = {{*vocabulary_.Find("table"), 0.875f}};
    table.position_m = {1.5, 1.5, -0.3};
    table.position_covariance_m2 = Eigen::Matrix3d::Zero();
    table.T_map_box.translation() = table.position_m;
    table.box_size_m = {1.0, 1.0, 0.7};
    table.min_height_m = -0.65;
    table.max_height_m = 0.05;
    table.hollow = semantic_slam::Hollowness::kFull;
    table.footprint_m = {{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}, {1.0, 2.0}};
    semantic_slam::ObjectMap map;
    map.stamp = NextStamp();
    map.map_id = 4;
    map.revision = 6;
    map.vocabulary_hash = vocabulary_.hash();
    map.objects = {table};
    return ToSemanticObjectArray(map, "map");
  }

  static semantic_slam::Stamp NextStamp() {
    static std::int64_t seconds = 1000;
    return semantic_slam::Stamp{++seconds * 1'000'000'000};
  }

  template <typename Done>
  ::testing::AssertionResult WaitForGrid(Done done) {
    if (SpinUntil([&] { return grids_.last() && done(*grids_.last()); }, kLimitS)) {
      return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure() << "no such grid came";
  }

  int WaitForDiagnostic(const std::string& key, int at_least) {
    int value = 0;
    SpinUntil(
        [&] {
          const std::string text = DiagnosticValue(*diagnostics_.last(), key);
          value = text.empty() ? 0 : std::stoi(text);
          return value >= at_least;
        },
        at_least > 0 ? kLimitS : 1.5);
    return value;
  }

  static long Count(const GridMsg& grid, std::uint8_t cost) {
    return std::count(grid.cost.begin(), grid.cost.end(), cost);
  }

  const LabelVocabulary vocabulary_ =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  ros::NodeHandle nh_;
  ros::Publisher map_pub_ = nh_.advertise<OccupancyGrid>("map", 10);
  ros::Publisher objects_pub_ = nh_.advertise<ObjectArrayMsg>("objects", 10);
  Listener<GridMsg> grids_{nh_, "semantic_grid"};
  Listener<OccupancyGrid> maps_{nh_, "semantic_map"};
  Listener<diagnostic_msgs::DiagnosticArray> diagnostics_{nh_, "/diagnostics"};
};

TEST_F(SemanticGridNodeTest, AMapAloneIsAGrid) {
  const OccupancyGrid room = Room();
  map_pub_.publish(room);
  ASSERT_TRUE(WaitForGrid([](const GridMsg& grid) { return !grid.cost.empty(); }));
  const GridMsg& grid = *grids_.last();
  EXPECT_EQ(grid.header.stamp, room.header.stamp);
  EXPECT_EQ(grid.header.frame_id, "map");
  EXPECT_EQ(grid.info.width, room.info.width);
  EXPECT_EQ(Count(grid, GridMsg::COST_FREE), kCells * kCells);
}

TEST_F(SemanticGridNodeTest, ATableOfTheObjectMapBecomesAnAreaOfBothGrids) {
  const ObjectArrayMsg table = Table();
  map_pub_.publish(Room());
  objects_pub_.publish(table);
  ASSERT_TRUE(WaitForGrid(
      [](const GridMsg& grid) { return Count(grid, GridMsg::COST_LETHAL) == 10 * 10; }));
  const GridMsg& grid = *grids_.last();
  EXPECT_EQ(grid.map_id, 4);
  EXPECT_EQ(grid.revision, 6u);
  EXPECT_EQ(grid.label_set_hash, vocabulary_.hash());
  const std::size_t cell = 15 * kCells + 15;
  EXPECT_EQ(grid.cost[cell], GridMsg::COST_LETHAL);
  EXPECT_EQ(grid.labels[grid.classes_per_cell * cell], *vocabulary_.Find("table"));
  EXPECT_EQ(grid.probabilities[grid.classes_per_cell * cell], 223) << "floor(255 * 0.875)";
  EXPECT_FLOAT_EQ(grid.max_height[cell], 0.05f);
  const auto shows_table = [&] {  // the empty map of the reset may come late
    return maps_.last() && maps_.last()->data.size() > cell && maps_.last()->data[cell] == 100;
  };
  ASSERT_TRUE(SpinUntil(shows_table, kLimitS));
  EXPECT_EQ(maps_.last()->header.stamp, grid.header.stamp);
  EXPECT_EQ(maps_.last()->data[0], 0);
}

TEST_F(SemanticGridNodeTest, LatchesTheGrid) {
  map_pub_.publish(Room());
  ASSERT_TRUE(WaitForGrid([](const GridMsg& grid) { return !grid.cost.empty(); }));
  Listener<GridMsg> late(nh_, "semantic_grid");
  EXPECT_TRUE(SpinUntil([&] { return late.last() && !late.last()->cost.empty(); }, kLimitS));
  Listener<OccupancyGrid> late_map(nh_, "semantic_map");
  EXPECT_TRUE(
      SpinUntil([&] { return late_map.last() && !late_map.last()->data.empty(); }, kLimitS));
}

TEST_F(SemanticGridNodeTest, DrawsForWhoBeginsToLook) {
  map_pub_.publish(Room());
  ASSERT_TRUE(WaitForGrid([](const GridMsg& grid) { return !grid.cost.empty(); }));
  Listener<sensor_msgs::Image> images(nh_, "semantic_grid_image");
  ASSERT_TRUE(SpinUntil([&] { return images.last() != nullptr; }, kLimitS));
  EXPECT_EQ(images.last()->encoding, "bgr8");
  EXPECT_GT(images.last()->width, 400u);
}

TEST_F(SemanticGridNodeTest, DropsAndCountsWhatIsMalformedAndLives) {
  map_pub_.publish(Room());
  objects_pub_.publish(Table());
  ASSERT_TRUE(
      WaitForGrid([](const GridMsg& grid) { return Count(grid, GridMsg::COST_LETHAL) > 0; }));
  const int bad_maps = WaitForDiagnostic("dropped: bad_map", 0);
  const int bad_objects = WaitForDiagnostic("dropped: bad_objects", 0);
  OccupancyGrid cut = Room();
  cut.data.pop_back();
  map_pub_.publish(cut);
  EXPECT_GT(WaitForDiagnostic("dropped: bad_map", bad_maps + 1), bad_maps);
  map_pub_.publish(Room());
  ObjectArrayMsg unknown = Table();
  unknown.objects[0].labels[0] = 200;
  objects_pub_.publish(unknown);
  EXPECT_GT(WaitForDiagnostic("dropped: bad_objects", bad_objects + 1), bad_objects);
  ObjectArrayMsg elsewhere = Table();
  elsewhere.header.frame_id = "odom";
  objects_pub_.publish(elsewhere);
  EXPECT_GT(WaitForDiagnostic("dropped: bad_objects", bad_objects + 2), bad_objects + 1);
  ObjectArrayMsg nothing = Table();
  nothing.objects.clear();
  objects_pub_.publish(nothing);
  EXPECT_TRUE(
      WaitForGrid([](const GridMsg& grid) { return Count(grid, GridMsg::COST_LETHAL) == 0; }));
}

TEST_F(SemanticGridNodeTest, SavesTheGrid) {
  const semantic_slam::TemporaryFolder folder;
  map_pub_.publish(Room());
  ASSERT_TRUE(WaitForGrid([](const GridMsg& grid) { return !grid.cost.empty(); }));
  semantic_slam::SaveMap save;
  ASSERT_TRUE(ros::service::call("semantic_grid/save_map", save));
  EXPECT_FALSE(save.response.success) << "without a path and ~output_directory";
  save.request.path = folder / "grid";
  // The service sees the grid right after it was published.
  ASSERT_TRUE(SpinUntil(
      [&] { return ros::service::call("semantic_grid/save_map", save) && save.response.success; },
      kLimitS))
      << save.response.message;
  for (const char* name : {"semantic_grid.png", "semantic_grid.pgm", "semantic_grid.yaml"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / ("grid/" + std::string(name)))) << name;
  }
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "semantic_grid_node_test");
  return RUN_ALL_TESTS();
}
