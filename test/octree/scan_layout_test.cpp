#include "semantic_slam/octree/scan_layout.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(ScanLayoutTest, NumbersEveryVoxelOnceAndFindsItAgain) {
  ScanLayout layout;
  const octomap::OcTreeKey lowest(32761, 32763, 32790), highest(32780, 32771, 32801);
  layout.Reset(lowest, highest);
  std::set<ScanLayout::Number> numbers;
  for (int x = lowest[0]; x <= highest[0]; ++x) {
    for (int y = lowest[1]; y <= highest[1]; ++y) {
      for (int z = lowest[2]; z <= highest[2]; ++z) {
        const octomap::OcTreeKey key(static_cast<octomap::key_type>(x),
                                     static_cast<octomap::key_type>(y),
                                     static_cast<octomap::key_type>(z));
        ASSERT_TRUE(layout.Covers(key));
        const ScanLayout::Number number = layout.NumberOf(key);
        EXPECT_EQ(number, layout.On(0, x) + layout.On(1, y) + layout.On(2, z));
        EXPECT_TRUE(numbers.insert(number).second);
        const std::size_t brick = number >> ScanLayout::kBrickBits;
        ASSERT_LT(brick, layout.bricks());
        const octomap::OcTreeKey corner = layout.CornerOf(brick);
        EXPECT_EQ(ScanLayout::KeyOf(corner, number & (ScanLayout::kBrickVoxels - 1)), key);
      }
    }
  }
}

TEST(ScanLayoutTest, ReachesToTheEdgesOfTheTree) {
  ScanLayout layout;
  layout.Reset({0, 0, 0}, {3, 3, 3});
  EXPECT_TRUE(layout.Covers({0, 0, 0}));
  EXPECT_EQ(layout.CornerOf(layout.NumberOf({0, 0, 0}) >> ScanLayout::kBrickBits),
            octomap::OcTreeKey(0, 0, 0));
  layout.Reset({65530, 65530, 65530}, {65535, 65535, 65535});
  EXPECT_TRUE(layout.Covers({65535, 65535, 65535}));
  EXPECT_FALSE(layout.Covers({0, 0, 0}));
  EXPECT_FALSE(layout.Covers({65535, 65535, 0}));
  EXPECT_EQ(layout.CornerOf(layout.NumberOf({65535, 65535, 65535}) >> ScanLayout::kBrickBits),
            octomap::OcTreeKey(65528, 65528, 65528));
}

}  // namespace
}  // namespace semantic_slam
