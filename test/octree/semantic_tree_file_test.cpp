#include "semantic_slam/octree/semantic_tree_file.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>
#include <octomap/AbstractOcTree.h>

#include "octree/octree_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/map_export.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::string Content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class SemanticTreeFileTest : public testing::Test {
 protected:
  SemanticTreeFileTest() : tree_(0.1), vocabulary_(SmallVocabulary()) {
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

TEST_F(SemanticTreeFileTest, TheSemanticTreeComesBackWhole) {
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

TEST_F(SemanticTreeFileTest, RefusesWhatIsNotItsOwn) {
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

TEST_F(SemanticTreeFileTest, RefusesAFileThatIsCutOrDamagedAnywhere) {
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

TEST_F(SemanticTreeFileTest, TellsItsLabelsItself) {
  WriteSemanticTree(folder_ / "map.ot", tree_, *vocabulary_);
  const LabelledTree read = ReadLabelledTree(folder_ / "map.ot");
  EXPECT_TRUE(*read.tree == tree_);
  EXPECT_EQ(read.vocabulary.hash(), vocabulary_->hash());
  EXPECT_EQ(read.vocabulary[5].rgb, (*vocabulary_)[5].rgb);
}

TEST_F(SemanticTreeFileTest, RefusesALegendThatIsNone) {
  WriteSemanticTree(folder_ / "map.ot", tree_, *vocabulary_);
  const std::string whole = Content(folder_ / "map.ot");
  const auto refusal = [&](const std::string& from, const std::string& to) {
    std::string changed = whole;
    changed.replace(changed.find(from), from.size(), to);
    const std::string path = folder_.Write("changed.ot", changed);
    return MessageOf<InputError>([&] { ReadLabelledTree(path); });
  };
  ExpectOneLineWith(refusal("# label 5 chair 214", "# label 5 chair 999"),
                    {"changed.ot", "5 chair 999"});
  ExpectOneLineWith(refusal("# label 5 chair", "# label 5 table"),
                    {"legend is damaged", "same id or name"});
  ExpectOneLineWith(refusal("# label 5 chair", "# label 5 stool"), {"another label set"});
}

}  // namespace
}  // namespace semantic_slam
