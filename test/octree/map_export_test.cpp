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

  std::string Refusal(const std::string& content) {
    const std::string path = folder_.Write("broken.ot", content);
    return MessageOf<InputError>([&] { ReadSemanticTree(path, *vocabulary_); });
  }

  TemporaryFolder folder_;
  SemanticOcTree tree_;
  std::shared_ptr<const LabelVocabulary> vocabulary_;
};

TEST_F(MapExportTest, TheSemanticTreeComesBackWhole) {
  const std::string path = folder_ / "map.ot";
  WriteSemanticTree(path, tree_, *vocabulary_);
  EXPECT_TRUE(*ReadSemanticTree(path, *vocabulary_) == tree_);
  EXPECT_NE(Content(path).find("# label 5 chair 214 39 40\n"), std::string::npos);

  // And from OctoMap's own reader.
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(path));
  auto* back = dynamic_cast<SemanticOcTree*>(read.get());
  ASSERT_NE(back, nullptr);
  EXPECT_TRUE(*back == tree_);
}

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

TEST_F(MapExportTest, RefusesWhatIsNotItsOwn) {
  ExpectOneLineWith(
      MessageOf<InputError>([&] { ReadSemanticTree(folder_ / "no.ot", *vocabulary_); }),
      {"cannot open", "no.ot"});
  ExpectOneLineWith(Refusal("P5 640 480"), {"broken.ot", "no OctoMap .ot file"});
  ExpectOneLineWith(Refusal(""), {"no OctoMap .ot file"});
  ExpectOneLineWith(Refusal("# Octomap OcTree file\nid Sem"), {"header ends too soon"});
  WriteColourTree(folder_ / "colour.ot", tree_, VoxelColours(ColourMode::kRgb, *vocabulary_));
  ExpectOneLineWith(Refusal(Content(folder_ / "colour.ot")),
                    {"'ColorOcTree'", "expected SemanticOcTree"});
  WriteSemanticTree(folder_ / "map.ot", tree_,
                    LabelVocabulary({{0, "unknown", {}}, {5, "stool", {}}}));
  ExpectOneLineWith(Refusal(Content(folder_ / "map.ot")), {"another label set"});
}

TEST_F(MapExportTest, RefusesAFileThatIsCutOrDamagedAnywhere) {
  WriteSemanticTree(folder_ / "map.ot", tree_, *vocabulary_);
  const std::string whole = Content(folder_ / "map.ot");
  for (const std::size_t size :
       {whole.size() - 1, whole.size() / 2, whole.find("data\n") + 5, whole.find("data\n")}) {
    EXPECT_NE(Refusal(whole.substr(0, size)), "") << size;
  }
  EXPECT_NE(Refusal(whole + "x"), "");
  const std::size_t nodes = whole.find("data\n") + 5;
  for (std::size_t i = nodes; i < whole.size(); i += 97) {
    // No damage may crash the reader; what changes an occupancy or a colour a little is not
    // noticed.
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0xff);
    Refusal(damaged);
  }
  std::string bottomless = whole.substr(0, nodes);
  for (int i = 0; i < 100; ++i)
    bottomless += std::string(16, '\0') + '\1';  // always one more child
  ExpectOneLineWith(Refusal(bottomless), {"too deep"});
  std::string infinite = whole;
  const float infinity = std::numeric_limits<float>::infinity();
  std::memcpy(&infinite[nodes], &infinity, sizeof(infinity));
  ExpectOneLineWith(Refusal(infinite), {"damaged"});
}

TEST_F(MapExportTest, SaysWhereItCannotWrite) {
  const std::string file = folder_.Write("file", "");
  ExpectOneLineWith(
      MessageOf<InputError>([&] { WriteMapFiles(file + "/map", tree_, *vocabulary_); }),
      {"file/map.ot"});
}

}  // namespace
}  // namespace semantic_slam
