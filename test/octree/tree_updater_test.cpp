#include "semantic_slam/octree/tree_updater.h"

#include <random>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

octomap::OcTreeKey Key(int x, int y, int z) {
  return {static_cast<octomap::key_type>(32768 + x), static_cast<octomap::key_type>(32768 + y),
          static_cast<octomap::key_type>(32768 + z)};
}

// A brick of which some voxels are hit and some passed.
ScanGrid::Brick BrickAt(const octomap::OcTreeKey& corner, std::uint64_t seed, bool any_hit) {
  std::mt19937_64 random(seed);
  ScanGrid::Brick brick;
  brick.corner = corner;
  for (unsigned word = 0; word < 8; ++word) {
    brick.hit[word] = any_hit ? random() & random() & random() : 0;
    brick.free[word] = (random() | random()) & ~brick.hit[word];
  }
  return brick;
}

bool HasBit(const ScanGrid::Words& words, unsigned place) {
  return words[place >> 6] >> (place & 63) & 1;
}

void IgnoreHit(SemanticNode&, bool, unsigned) {}

TEST(TreeUpdaterTest, LeavesTheTreeAloneWithoutUpdates) {
  SemanticOcTree tree(0.1);
  { TreeUpdater updater(tree); }
  EXPECT_EQ(tree.getRoot(), nullptr);
}

// In any order of bricks, not only in that which is fast, it is OctoMap's updateNode().
TEST(TreeUpdaterTest, EqualsUpdatingVoxelByVoxel) {
  std::mt19937 random(9);
  SemanticOcTree tree(0.1), expected(0.1);
  tree.SetOccupancy({});
  expected.SetOccupancy({});
  for (int round = 0; round < 12; ++round) {
    TreeUpdater updater(tree);
    for (int i = 0; i < 12; ++i) {
      const auto brick = BrickAt(Key(8 * static_cast<int>(random() % 3), 0, -8 * (i % 2)), random(),
                                 random() % 3 == 0);
      std::array<bool, 512> was_occupied{};
      for (unsigned place = 0; place < 512; ++place) {
        const octomap::OcTreeKey key = ScanLayout::KeyOf(brick.corner, place);
        const SemanticNode* before = expected.search(key);
        was_occupied[place] = before != nullptr && expected.isNodeOccupied(before);
        if (HasBit(brick.hit, place)) expected.updateNode(key, true);
        if (HasBit(brick.free, place)) expected.updateNode(key, false);
      }
      updater.Update(brick, [&](SemanticNode&, bool occupied, unsigned place) {
        EXPECT_TRUE(HasBit(brick.hit, place));
        EXPECT_EQ(occupied, was_occupied[place]);
      });
    }
  }
  EXPECT_TRUE(tree == expected);
}

TEST(TreeUpdaterTest, DoesNotExpandABlockThatCanGetNoFreer) {
  SemanticOcTree tree(0.1);
  tree.SetOccupancy({});
  ScanGrid::Brick brick;
  brick.corner = Key(0, 0, 0);
  brick.free.fill(~std::uint64_t{0});
  const auto clear = [&] { TreeUpdater(tree).Update(brick, IgnoreHit); };
  for (int i = 0; i < 10; ++i) clear();
  const std::size_t joined = tree.size();
  EXPECT_EQ(joined, 14u);  // a path from the root to one block at depth 13
  clear();
  EXPECT_EQ(tree.size(), joined);
}

TEST(TreeUpdaterTest, JoinsABlockAgainThatItHadToExpand) {
  SemanticOcTree tree(0.1);
  tree.SetOccupancy({});
  ScanGrid::Brick clear;
  clear.corner = Key(0, 0, 0);
  clear.free[0] = 0xff;  // the first eight voxels
  for (int pass = 0; pass < 10; ++pass) TreeUpdater(tree).Update(clear, IgnoreHit);
  const std::size_t joined = tree.size();
  ScanGrid::Brick hit;
  hit.corner = clear.corner;
  hit.hit[0] = 2;
  TreeUpdater(tree).Update(hit, [](SemanticNode&, bool was_occupied, unsigned place) {
    EXPECT_FALSE(was_occupied);
    EXPECT_EQ(place, 1u);
  });
  EXPECT_EQ(tree.size(), joined + 8);
  clear.free[0] = 2;
  for (int pass = 0; pass < 10; ++pass) TreeUpdater(tree).Update(clear, IgnoreHit);
  EXPECT_EQ(tree.size(), joined);
}

}  // namespace
}  // namespace semantic_slam
