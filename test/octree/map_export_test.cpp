#include "semantic_slam/octree/map_export.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <octomap/OcTree.h>

#include "octree/octree_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/semantic_tree_file.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::string Content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class MapExportTest : public testing::Test {
 protected:
  MapExportTest() : tree_(0.1), vocabulary_(SmallVocabulary()) {
    AddRoom(tree_);
    tree_.setNodeValue(0.55, 0.55, 0.35, -1.5f);
    tree_.prune();
  }

  TemporaryFolder folder_;
  SemanticOcTree tree_;
  std::shared_ptr<const LabelVocabulary> vocabulary_;
};

TEST_F(MapExportTest, AnEmptyTreeComesBackEmpty) {
  const SemanticOcTree empty(0.2);
  WriteMapFiles(folder_ / "empty", empty, *vocabulary_);
  EXPECT_EQ(ReadSemanticTree(folder_ / "empty.ot", *vocabulary_)->size(), 0u);
  EXPECT_NE(Content(folder_ / "empty.ply").find("element vertex 0\n"), std::string::npos);
}

TEST_F(MapExportTest, TheSameMapGivesTheSameBytes) {
  WriteMapFiles(folder_ / "a", tree_, *vocabulary_);
  WriteMapFiles(folder_ / "b", tree_, *vocabulary_);
  for (const char* suffix : {".ot", "_colour.ot", ".bt", ".ply"}) {
    const std::string content = Content(folder_ / ("a" + std::string(suffix)));
    EXPECT_FALSE(content.empty());
    EXPECT_EQ(content, Content(folder_ / ("b" + std::string(suffix)))) << suffix;
  }
}

TEST_F(MapExportTest, OctomapReadsTheColouredTree) {
  const std::string path = folder_ / "colour.ot";
  WriteColourTree(path, tree_, VoxelColours(ColourMode::kClass, *vocabulary_));
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(path));
  auto* coloured = dynamic_cast<octomap::ColorOcTree*>(read.get());
  ASSERT_NE(coloured, nullptr);
  EXPECT_EQ(coloured->size(), tree_.size());
  const auto* table = coloured->search(0.75, 0.55, 0.75);
  ASSERT_NE(table, nullptr);
  EXPECT_TRUE(coloured->isNodeOccupied(table));
  EXPECT_TRUE(table->getColor() == octomap::ColorOcTreeNode::Color(255, 127, 14));
}

// The height that the colour is of is the leaf's.
TEST_F(MapExportTest, ColoursByHeightFollowTheHeight) {
  const std::string path = folder_ / "height.ot";
  WriteColourTree(path, tree_, VoxelColours(ColourMode::kHeight, *vocabulary_, 0.05, 2.55));
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(path));
  auto* coloured = dynamic_cast<octomap::ColorOcTree*>(read.get());
  ASSERT_NE(coloured, nullptr);
  EXPECT_TRUE(coloured->search(0.15, 0.55, 0.05)->getColor() ==
              octomap::ColorOcTreeNode::Color(0, 0, 255));
  EXPECT_TRUE(coloured->search(0.15, 0.55, 2.55)->getColor() ==
              octomap::ColorOcTreeNode::Color(255, 0, 0));
}

TEST_F(MapExportTest, OctomapReadsTheBinaryTree) {
  const std::string path = folder_ / "map.bt";
  WriteBinaryTree(path, tree_);
  octomap::OcTree occupancy(1.0);
  ASSERT_TRUE(occupancy.readBinary(path));
  EXPECT_EQ(occupancy.getResolution(), 0.1);
  EXPECT_TRUE(occupancy.isNodeOccupied(occupancy.search(0.75, 0.55, 0.75)));
  EXPECT_FALSE(occupancy.isNodeOccupied(occupancy.search(0.55, 0.55, 0.35)));
  EXPECT_EQ(occupancy.search(0.55, 0.55, 1.5), nullptr);
}

TEST_F(MapExportTest, APointPerOccupiedVoxel) {
  const std::string path = folder_ / "map.ply";
  WritePointCloud(path, tree_, VoxelColours(ColourMode::kClass, *vocabulary_));
  const std::string content = Content(path);
  constexpr std::size_t kBytesPerPoint = 3 * 4 + 3 + 1 + 4;
  const std::size_t header = content.find("end_header\n") + 11;
  ASSERT_NE(content.find("element vertex 425\n"), std::string::npos) << content.substr(0, header);
  ASSERT_EQ(content.size(), header + 425 * kBytesPerPoint);
  std::size_t tables = 0;
  for (std::size_t i = 0; i < 425; ++i) {
    const char* point = content.data() + header + i * kBytesPerPoint;
    float z = 0.0f, probability = 0.0f;
    std::memcpy(&z, point + 8, 4);
    std::memcpy(&probability, point + 16, 4);
    if (point[15] != 7) continue;
    ++tables;
    EXPECT_FLOAT_EQ(z, 0.75f);
    EXPECT_NEAR(probability, 0.8f, 1e-4f);  // steps of 1/16383
    EXPECT_EQ(static_cast<std::uint8_t>(point[12]), 255);
  }
  EXPECT_EQ(tables, 25u);
}

TEST_F(MapExportTest, APcdHasTheSamePoints) {
  const std::string path = folder_ / "map.pcd";
  WritePcd(path, tree_, VoxelColours(ColourMode::kClass, *vocabulary_));
  const std::string content = Content(path);
  constexpr std::size_t kBytesPerPoint = 4 * 4 + 1 + 4;
  const std::size_t header = content.find("DATA binary\n") + 12;
  ASSERT_NE(content.find("\nPOINTS 425\n"), std::string::npos) << content.substr(0, header);
  ASSERT_EQ(content.size(), header + 425 * kBytesPerPoint);
  std::size_t tables = 0;
  for (std::size_t i = 0; i < 425; ++i) {
    const char* point = content.data() + header + i * kBytesPerPoint;
    std::uint32_t rgb = 0;
    std::memcpy(&rgb, point + 12, 4);
    EXPECT_EQ(point[16] == 7, rgb == 0xff7f0eu);
    tables += point[16] == 7;
  }
  EXPECT_EQ(tables, 25u);
}

TEST_F(MapExportTest, SaysWhereItCannotWrite) {
  const std::string file = folder_.Write("file", "");
  ExpectOneLineWith(
      MessageOf<InputError>([&] { WriteMapFiles(file + "/map", tree_, *vocabulary_); }),
      {"file/map.ot"});
}

}  // namespace
}  // namespace semantic_slam
