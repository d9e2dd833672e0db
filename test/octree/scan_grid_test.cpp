#include "semantic_slam/octree/scan_grid.h"

#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// Where a voxel stands in an octree's order.
std::uint64_t Morton(const octomap::OcTreeKey& key) {
  std::uint64_t code = 0;
  for (int bit = 15; bit >= 0; --bit) code = code << 3 | octomap::computeChildIdx(key, bit);
  return code;
}

TEST(ScanGridTest, VisitsWhatWasMarkedOnceInTheTreesOrder) {
  std::mt19937 random(1);
  const octomap::OcTreeKey lowest(32700, 32750, 32760), highest(32790, 32800, 32780);
  ScanGrid grid;
  for (int scan = 0; scan < 2; ++scan) {  // the second time with what the first one left
    grid.Reset(lowest, highest);
    std::map<std::uint64_t, bool> marked;
    for (int i = 0; i < 3000; ++i) {
      const octomap::OcTreeKey key(static_cast<octomap::key_type>(lowest[0] + random() % 91),
                                   static_cast<octomap::key_type>(lowest[1] + random() % 51),
                                   static_cast<octomap::key_type>(lowest[2] + random() % 21));
      ASSERT_TRUE(grid.Covers(key));
      const bool hit = i % 4 == 0;
      if (hit) {
        grid.MarkHit(key);
      } else {
        ScanGrid::MarkFree(grid.BrickAt(key[0], key[1], key[2]), key[0], key[1], key[2]);
      }
      marked[Morton(key)] |= hit;
    }
    auto expected = marked.begin();
    grid.ForEachUpdate([&](const octomap::OcTreeKey& key, bool is_hit, std::uint32_t) {
      ASSERT_NE(expected, marked.end());
      EXPECT_EQ(Morton(key), expected->first);
      EXPECT_EQ(is_hit, expected->second);
      ++expected;
    });
    EXPECT_EQ(expected, marked.end());
  }
}

TEST(ScanGridTest, NumbersEndsInTheTreesOrder) {
  std::mt19937 random(2);
  ScanGrid grid;
  grid.Reset({100, 100, 100}, {160, 160, 160});
  std::map<std::uint64_t, octomap::OcTreeKey> ends;
  for (int i = 0; i < 500; ++i) {
    const octomap::OcTreeKey key(static_cast<octomap::key_type>(100 + random() % 61),
                                 static_cast<octomap::key_type>(100 + random() % 61),
                                 static_cast<octomap::key_type>(100 + random() % 61));
    grid.MarkEnd(key);
    grid.MarkHit(key);
    ends[Morton(key)] = key;
  }
  EXPECT_EQ(grid.AssignSlots(), ends.size());
  std::uint32_t slot = 0;
  for (const auto& [morton, key] : ends) EXPECT_EQ(grid.SlotOf(key), slot++);
  slot = 0;
  grid.ForEachUpdate([&](const octomap::OcTreeKey&, bool is_hit, std::uint32_t visited) {
    EXPECT_TRUE(is_hit);
    EXPECT_EQ(visited, slot++);
  });
}

TEST(ScanGridTest, ReachesToTheEdgesOfTheTree) {
  ScanGrid grid;
  grid.Reset({0, 0, 0}, {3, 3, 3});
  EXPECT_TRUE(grid.Covers({0, 0, 0}));
  grid.MarkHit({0, 0, 0});
  grid.Reset({65530, 65530, 65530}, {65535, 65535, 65535});
  EXPECT_TRUE(grid.Covers({65535, 65535, 65535}));
  EXPECT_FALSE(grid.Covers({0, 0, 0}));
  grid.MarkHit({65535, 65535, 65535});
  int visited = 0;
  grid.ForEachUpdate([&](const octomap::OcTreeKey& key, bool, std::uint32_t) {
    EXPECT_EQ(key, octomap::OcTreeKey(65535, 65535, 65535));
    ++visited;
  });
  EXPECT_EQ(visited, 1);
}

}  // namespace
}  // namespace semantic_slam
