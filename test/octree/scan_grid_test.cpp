#include "semantic_slam/octree/scan_grid.h"

#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

// Where a voxel stands in an octree's order.
std::uint64_t Morton(const octomap::OcTreeKey& key) {
  std::uint64_t code = 0;
  for (int bit = 15; bit >= 0; --bit) code = code << 3 | octomap::computeChildIdx(key, bit);
  return code;
}

octomap::OcTreeKey RandomKey(std::mt19937& random, const octomap::OcTreeKey& lowest, int span) {
  octomap::OcTreeKey key;
  for (unsigned i = 0; i < 3; ++i)
    key[i] = static_cast<octomap::key_type>(lowest[i] + random() % static_cast<unsigned>(span));
  return key;
}

struct Update {
  octomap::OcTreeKey key;
  bool is_hit;
};

std::vector<Update> UpdatesOf(ScanGrid& grid) {
  std::vector<Update> updates;
  grid.ForEachBrick([&](const ScanGrid::Brick& brick) {
    for (unsigned place = 0; place < 512; ++place) {
      const bool hit = brick.hit[place >> 6] >> (place & 63) & 1;
      const bool free = brick.free[place >> 6] >> (place & 63) & 1;
      EXPECT_FALSE(hit && free);
      if (hit || free) updates.push_back({ScanLayout::KeyOf(brick.corner, place), hit});
    }
  });
  return updates;
}

TEST(ScanGridTest, NumbersEndsAsTheyComeAndVisitsThemInTheTreesOrder) {
  std::mt19937 random(1);
  const octomap::OcTreeKey lowest(32700, 32750, 32760);
  ScanGrid grid;
  for (int scan = 0; scan < 2; ++scan) {  // the second time with what the first one left
    grid.Reset(lowest, {32790, 32840, 32850});
    std::map<std::uint64_t, ScanGrid::EndId> ends;
    for (int i = 0; i < 3000; ++i) {
      const octomap::OcTreeKey key = RandomKey(random, lowest, 91);
      ASSERT_TRUE(grid.layout().Covers(key));
      const ScanGrid::EndId before = grid.ends(), end = grid.AddEnd(key);
      const auto [found, is_new] = ends.emplace(Morton(key), before);
      EXPECT_EQ(end, found->second);
      EXPECT_EQ(grid.ends(), before + is_new);
    }
    auto expected = ends.begin();
    grid.ForEachEnd([&](ScanGrid::EndId end, const octomap::OcTreeKey& key, ScanGrid::BitId bit) {
      ASSERT_NE(expected, ends.end());
      EXPECT_EQ(Morton(key), expected->first);
      EXPECT_EQ(end, expected->second);
      ++expected;
      if (end % 3 == 0) grid.MarkHit(bit);
    });
    EXPECT_EQ(expected, ends.end());
    std::size_t hits = 0;
    for (const Update& update : UpdatesOf(grid)) {
      EXPECT_TRUE(update.is_hit);
      EXPECT_EQ(ends.at(Morton(update.key)) % 3, 0u);
      ++hits;
    }
    EXPECT_EQ(hits, (ends.size() + 2) / 3);
  }
}

TEST(ScanGridTest, AHitIsNotFree) {
  const SemanticOcTree tree(0.1);
  ScanGrid grid;
  grid.Reset({32760, 32760, 32760}, {32790, 32790, 32790});
  const octomap::OcTreeKey origin = tree.coordToKey(0.05, 0.05, 0.05);
  RayLayer rays;
  rays.Reset(grid.layout(), tree);
  rays.Mark(RayWalk(tree, tree.keyToCoord(origin), origin, {1.05f, 0.05f, 0.05f}));
  grid.AddEnd({origin[0], origin[1], origin[2]});
  const octomap::OcTreeKey hit(static_cast<octomap::key_type>(origin[0] + 3), origin[1], origin[2]);
  grid.AddEnd(hit);
  grid.ForEachEnd([&](ScanGrid::EndId end, const octomap::OcTreeKey&, ScanGrid::BitId bit) {
    if (end == 1) grid.MarkHit(bit);
  });
  grid.AddFree(rays);
  const auto updates = UpdatesOf(grid);
  EXPECT_EQ(updates.size(), 10u);
  for (const Update& update : updates) EXPECT_EQ(update.is_hit, update.key == hit);
}

TEST(ScanGridTest, LimitsTheHeight) {
  ScanGrid grid;
  const octomap::OcTreeKey lowest(32760, 32760, 32760);
  grid.Reset(lowest, {32800, 32800, 32800});
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) grid.AddEnd(RandomKey(random, lowest, 40));
  std::size_t inside = 0;
  grid.ForEachEnd([&](ScanGrid::EndId, const octomap::OcTreeKey& key, ScanGrid::BitId bit) {
    grid.MarkHit(bit);
    inside += key[2] >= 32770 && key[2] <= 32779;
  });
  grid.LimitHeight(32770, 32779);
  const auto updates = UpdatesOf(grid);
  EXPECT_EQ(updates.size(), inside);
  for (const Update& update : updates) {
    EXPECT_GE(update.key[2], 32770);
    EXPECT_LE(update.key[2], 32779);
  }
}

}  // namespace
}  // namespace semantic_slam
