#include "semantic_slam_ros/octree_conversions.h"

#include <cstring>

#include <gtest/gtest.h>

#include "octree/octree_testing.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {
namespace {

using semantic_slam::ColourMode;
using semantic_slam::LabelVocabulary;
using semantic_slam::SemanticOcTree;
using semantic_slam::VoxelColours;
using visualization_msgs::Marker;

constexpr semantic_slam::LabelId kChair = 5, kTable = 7;
constexpr double kNoLimit = 1e9;

class OctreeConversionsTest : public testing::Test {
 protected:
  OctreeConversionsTest() : tree_(0.1), vocabulary_(semantic_slam::SmallVocabulary()) {
    // A block of eight that is joined, and a single voxel.
    for (int i = 0; i < 8; ++i) {
      semantic_slam::AddVoxel(
          tree_, {0.05 + 0.1 * (i & 1), 0.05 + 0.1 * (i >> 1 & 1), 0.05 + 0.1 * (i >> 2)}, kTable);
    }
    semantic_slam::AddVoxel(tree_, {-1.95, 0.05, 0.05}, kChair);
    tree_.setNodeValue(3.0, 3.0, 3.0, -1.0f, true);
    tree_.updateInnerOccupancy();
    tree_.prune();
    cells_ = CollectOccupiedCells(tree_, VoxelColours(ColourMode::kClass, *vocabulary_));
  }

  const std_msgs::Header header_ = MakeHeader(Stamp{5'000'000'000}, "map");
  SemanticOcTree tree_;
  std::shared_ptr<const LabelVocabulary> vocabulary_;
  OccupiedCells cells_;
};

TEST_F(OctreeConversionsTest, CollectsTheOccupiedLeaves) {
  ASSERT_EQ(cells_.cells.size(), 2u);
  EXPECT_EQ(cells_.cells[0].depth, 16);
  EXPECT_EQ(cells_.cells[0].label, kChair);
  EXPECT_EQ(cells_.cells[1].depth, 15);
  EXPECT_EQ(cells_.cells[1].rgb, (std::array<std::uint8_t, 3>{255, 127, 14}));
  EXPECT_NEAR(cells_.cells[1].probability, 0.8f, 1e-4f);  // steps of 1/16383
  EXPECT_EQ(LabelsIn(cells_), (std::vector<semantic_slam::LabelId>{kChair, kTable}));
}

TEST_F(OctreeConversionsTest, MarkersAreCubesOfEachSize) {
  const auto array = ToMarkers(cells_, header_, kNoLimit);
  ASSERT_EQ(array.markers.size(), 17u);
  for (int depth = 0; depth <= 16; ++depth) {
    const Marker& marker = array.markers[depth];
    EXPECT_EQ(marker.id, depth);
    EXPECT_EQ(marker.header, header_);
    EXPECT_EQ(marker.action, depth >= 15 ? Marker::ADD : Marker::DELETE);
  }
  EXPECT_NEAR(array.markers[15].scale.x, 0.2, 1e-9);
  EXPECT_NEAR(array.markers[15].points[0].x, 0.1, 1e-6);  // coordinates are float
  EXPECT_NEAR(array.markers[15].colors[0].g, 127.0 / 255.0, 1e-6);
}

TEST_F(OctreeConversionsTest, ACloudHasAPointForEachCell) {
  const auto msg = ToPointCloud2(cells_, header_);
  EXPECT_EQ(msg.width, 2u);
  EXPECT_EQ(msg.data.size(), 2 * msg.point_step);
  const auto read = [&](std::size_t point, const std::string& name, auto value) {
    for (const auto& field : msg.fields) {
      if (field.name == name)
        std::memcpy(&value, &msg.data[point * msg.point_step + field.offset], sizeof(value));
    }
    return value;
  };
  EXPECT_NEAR(read(0, "x", 0.0f), -1.95f, 1e-6f);  // coordinates are float
  EXPECT_EQ(read(0, "label", std::uint8_t{0}), kChair);
  EXPECT_EQ(read(1, "rgb", std::uint32_t{0}), 0xff7f0eu);
  EXPECT_FLOAT_EQ(read(1, "size", 0.0f), 0.2f);
  EXPECT_NEAR(read(1, "probability", 0.0f), 0.8f, 1e-4f);  // steps of 1/16383
}

TEST_F(OctreeConversionsTest, TheLegendNamesTheClassesInTheirColours) {
  const auto array = ToLegend(cells_, *vocabulary_, header_);
  ASSERT_EQ(array.markers.size(), 5u);
  EXPECT_EQ(array.markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(array.markers[2].text, "chair");
  EXPECT_EQ(array.markers[4].text, "table");
  EXPECT_NEAR(array.markers[3].color.r, 1.0, 1e-6);
  EXPECT_LT(array.markers[1].pose.position.x, -2.0);
  EXPECT_LT(array.markers[3].pose.position.z, array.markers[1].pose.position.z);
}

TEST_F(OctreeConversionsTest, MarkersEndAtAHeight) {
  // The block's centre is 0.1 m high, the single voxel's 0.05 m.
  const auto array = ToMarkers(cells_, header_, 0.07);
  EXPECT_EQ(array.markers[16].action, Marker::ADD);
  EXPECT_EQ(array.markers[15].action, Marker::DELETE);
}

TEST_F(OctreeConversionsTest, ALongLegendGoesOnBesideItself) {
  OccupiedCells many = cells_;
  many.cells.clear();
  std::vector<semantic_slam::LabelClass> classes = vocabulary_->classes();
  for (int i = 0; i < 12; ++i) {
    const auto id = static_cast<semantic_slam::LabelId>(100 + i);
    classes.push_back({id, "class" + std::to_string(i), {0, 0, 0}});
    many.cells.push_back({{0, 0, 0}, 16, {0, 0, 0}, id, 1.0f});
  }
  const auto array = ToLegend(many, LabelVocabulary(classes), header_);
  ASSERT_EQ(array.markers.size(), 25u);
  const auto place = [&](int i) { return array.markers[1 + 2 * i].pose.position; };
  EXPECT_LT(place(9).z, place(0).z - 3.0);
  EXPECT_DOUBLE_EQ(place(10).z, place(0).z);
  EXPECT_LT(place(10).y, place(9).y - 0.5);
}

TEST_F(OctreeConversionsTest, AnEmptyTreeShowsNothing) {
  const SemanticOcTree empty(0.1);
  const OccupiedCells nothing =
      CollectOccupiedCells(empty, VoxelColours(ColourMode::kRgb, *vocabulary_));
  for (const Marker& marker : ToMarkers(nothing, header_, kNoLimit).markers)
    EXPECT_EQ(marker.action, Marker::DELETE);
  EXPECT_EQ(ToPointCloud2(nothing, header_).width, 0u);
  EXPECT_EQ(ToLegend(nothing, *vocabulary_, header_).markers.size(), 1u);
}

}  // namespace
}  // namespace semantic_slam_ros
