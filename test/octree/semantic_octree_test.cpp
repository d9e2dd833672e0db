#include "semantic_slam/octree/semantic_octree.h"

#include <memory>
#include <sstream>

#include <gtest/gtest.h>
#include <octomap/AbstractOcTree.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

constexpr double kResolutionM = 0.1;
constexpr LabelId kChair = 5, kTable = 7;

// The eight voxels of one block, all with the same occupancy.
SemanticNode* Block(SemanticOcTree& tree, float log_odds) {
  for (int i = 0; i < 8; ++i) {
    tree.setNodeValue(0.05 + 0.1 * (i & 1), 0.05 + 0.1 * (i >> 1 & 1), 0.05 + 0.1 * (i >> 2),
                      log_odds, true);
  }
  return tree.search(octomap::point3d(0.05f, 0.05f, 0.05f), 15);
}

void Label(SemanticOcTree& tree, SemanticNode* block, int child, LabelId label, float probability) {
  tree.getNodeChild(block, child)->SetLabels(CompactLabels(Distribution(label, probability)));
}

TEST(SemanticNodeTest, HasRoomForMillions) {
  EXPECT_EQ(sizeof(SemanticNode), 24u);
}

TEST(SemanticOcTreeTest, JoinsFreeVoxelsWhateverTheirLabels) {
  SemanticOcTree tree(kResolutionM);
  SemanticNode* block = Block(tree, -1.0f);
  Label(tree, block, 3, kChair, 0.9f);
  ASSERT_TRUE(tree.pruneNode(block));
  EXPECT_FALSE(tree.nodeHasChildren(block));
  EXPECT_FLOAT_EQ(block->getLogOdds(), -1.0f);
  EXPECT_TRUE(block->labels() == CompactLabels());
}

TEST(SemanticOcTreeTest, JoinsOccupiedVoxelsOnlyWhereLabelsAgree) {
  SemanticOcTree tree(kResolutionM);
  SemanticNode* block = Block(tree, 2.0f);
  for (int i = 0; i < 8; ++i) {
    Label(tree, block, i, kChair, 0.9f);
    tree.getNodeChild(block, i)->SetRgb({static_cast<std::uint8_t>(10 * i), 0, 0});
  }
  Label(tree, block, 6, kTable, 0.9f);
  EXPECT_FALSE(tree.pruneNode(block));
  Label(tree, block, 6, kChair, 0.9f);
  ASSERT_TRUE(tree.pruneNode(block));
  EXPECT_TRUE(block->labels() == CompactLabels(Distribution(kChair, 0.9f)));
  EXPECT_EQ(block->rgb()[0], 35);

  // Expanded again, every voxel has what the block had.
  tree.expandNode(block);
  EXPECT_TRUE(*tree.getNodeChild(block, 5) == *tree.getNodeChild(block, 0));
  EXPECT_TRUE(tree.getNodeChild(block, 5)->labels() == CompactLabels(Distribution(kChair, 0.9f)));
}

TEST(SemanticOcTreeTest, JoinsNothingThatIsIncompleteOrOfOtherOccupancy) {
  SemanticOcTree tree(kResolutionM);
  SemanticNode* block = Block(tree, -1.0f);
  tree.getNodeChild(block, 7)->setLogOdds(-0.5f);
  EXPECT_FALSE(tree.pruneNode(block));
  tree.deleteNodeChild(block, 7);
  EXPECT_FALSE(tree.pruneNode(block));
}

TEST(SemanticOcTreeTest, AnInnerNodeSummarisesItsOccupiedChildren) {
  SemanticOcTree tree(kResolutionM);
  SemanticNode* block = Block(tree, -1.0f);
  Label(tree, block, 0, kTable, 0.9f);  // free: has no say
  for (const int child : {1, 2, 3}) tree.getNodeChild(block, child)->setLogOdds(0.5f * child);
  Label(tree, block, 1, kChair, 0.8f);
  Label(tree, block, 2, kChair, 0.4f);
  Label(tree, block, 3, kTable, 0.6f);
  tree.getNodeChild(block, 1)->SetRgb({30, 60, 90});
  tree.SummariseChildren(block);
  EXPECT_FLOAT_EQ(block->getLogOdds(), 1.5f);
  const LabelDistribution labels = block->labels().Unpacked();
  EXPECT_EQ(labels.labels, (std::array<LabelId, 3>{kChair, kTable, 0}));
  EXPECT_NEAR(labels.probabilities[0], 0.4f, 1e-4f);  // steps of 1/16383
  EXPECT_NEAR(labels.probabilities[1], 0.2f, 1e-4f);
  EXPECT_EQ(block->rgb(), (SemanticNode::Rgb{10, 20, 30}));
}

TEST(SemanticOcTreeTest, ComesBackFromAnyReaderOfTreesByItsId) {
  SemanticOcTree tree(kResolutionM);
  SemanticNode* block = Block(tree, 1.0f);
  Label(tree, block, 2, kTable, 0.7f);
  tree.getNodeChild(block, 2)->SetRgb({1, 2, 3});
  std::stringstream file;
  ASSERT_TRUE(tree.write(file));
  const std::unique_ptr<octomap::AbstractOcTree> read(octomap::AbstractOcTree::read(file));
  auto* back = dynamic_cast<SemanticOcTree*>(read.get());
  ASSERT_NE(back, nullptr);
  EXPECT_EQ(back->getResolution(), kResolutionM);
  EXPECT_EQ(back->size(), tree.size());
  EXPECT_TRUE(*back == tree);
}

TEST(SemanticOcTreeTest, OccupancyOptionsAreProbabilities) {
  SemanticOcTree tree(kResolutionM);
  OccupancyOptions options;
  options.hit = 0.8;
  options.miss = 0.3;
  options.occupied = 0.6;
  tree.SetOccupancy(options);
  EXPECT_NEAR(tree.getProbHit(), 0.8, 1e-6);  // log-odds are float
  EXPECT_NEAR(tree.getProbMiss(), 0.3, 1e-6);
  EXPECT_NEAR(tree.getOccupancyThres(), 0.6, 1e-6);
  EXPECT_NEAR(tree.hit_log_odds(), std::log(0.8 / 0.2), 1e-6);
}

TEST(SemanticOcTreeTest, LowestKeyIsTheCornerOfABlock) {
  const SemanticOcTree tree(kResolutionM);
  EXPECT_EQ(tree.LowestKey({32769, 32774, 32767}, 14), octomap::OcTreeKey(32768, 32772, 32764));
  EXPECT_EQ(tree.LowestKey({5, 6, 7}, 16), octomap::OcTreeKey(5, 6, 7));
}

}  // namespace
}  // namespace semantic_slam
