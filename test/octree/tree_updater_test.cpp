#include "semantic_slam/octree/tree_updater.h"

#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

octomap::OcTreeKey Key(int x, int y, int z) {
  return {static_cast<octomap::key_type>(32768 + x), static_cast<octomap::key_type>(32768 + y),
          static_cast<octomap::key_type>(32768 + z)};
}

TEST(TreeUpdaterTest, LeavesTheTreeAloneWithoutUpdates) {
  SemanticOcTree tree(0.1);
  { TreeUpdater updater(tree); }
  EXPECT_EQ(tree.getRoot(), nullptr);
}

// In any order of voxels, not only in that which is fast, it is OctoMap's updateNode().
TEST(TreeUpdaterTest, EqualsUpdatingVoxelByVoxel) {
  std::mt19937 random(9);
  SemanticOcTree tree(0.1), expected(0.1);
  tree.SetOccupancy({});
  expected.SetOccupancy({});
  for (int round = 0; round < 20; ++round) {
    TreeUpdater updater(tree);
    for (int i = 0; i < 400; ++i) {
      const auto key = Key(random() % 6, random() % 6, random() % 6);
      if (random() % 4 == 0) {
        bool was_occupied = false;
        const SemanticNode* before = expected.search(key);
        const bool expected_before = before != nullptr && expected.isNodeOccupied(before);
        updater.Hit(key, &was_occupied);
        EXPECT_EQ(was_occupied, expected_before);
        expected.updateNode(key, true);
      } else {
        updater.Miss(key);
        expected.updateNode(key, false);
      }
    }
  }
  EXPECT_TRUE(tree == expected);
}

TEST(TreeUpdaterTest, DoesNotExpandABlockThatCanGetNoFreer) {
  SemanticOcTree tree(0.1);
  tree.SetOccupancy({});
  const auto clear = [&] {
    TreeUpdater updater(tree);
    for (int i = 0; i < 512; ++i) updater.Miss(Key(i & 7, i >> 3 & 7, i >> 6));
  };
  for (int i = 0; i < 10; ++i) clear();
  const std::size_t joined = tree.size();
  EXPECT_EQ(joined, 14u);  // a path from the root to one block at depth 13
  clear();
  EXPECT_EQ(tree.size(), joined);
}

TEST(TreeUpdaterTest, JoinsABlockAgainThatItHadToExpand) {
  SemanticOcTree tree(0.1);
  tree.SetOccupancy({});
  for (int pass = 0; pass < 10; ++pass) {
    TreeUpdater updater(tree);
    for (int i = 0; i < 8; ++i) updater.Miss(Key(i & 1, i >> 1 & 1, i >> 2));
  }
  const std::size_t joined = tree.size();
  {
    TreeUpdater updater(tree);
    bool was_occupied = true;
    updater.Hit(Key(1, 0, 0), &was_occupied);
    EXPECT_FALSE(was_occupied);
  }
  EXPECT_EQ(tree.size(), joined + 8);
  for (int pass = 0; pass < 10; ++pass) TreeUpdater(tree).Miss(Key(1, 0, 0));
  EXPECT_EQ(tree.size(), joined);
}

}  // namespace
}  // namespace semantic_slam
