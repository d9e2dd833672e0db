#include "semantic_slam/common/lanes.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(LanesTest, FloorRoundsDown) {
  const Ints4 floors = Floor(Floats4{1.5f, -1.5f, 2.0f, -3.0f});
  EXPECT_EQ(floors[0], 1);
  EXPECT_EQ(floors[1], -2);
  EXPECT_EQ(floors[2], 2);
  EXPECT_EQ(floors[3], -3);
}

TEST(LanesTest, AllNeedsEveryLane) {
  const Ints4 a{1, 2, 3, 4};
  EXPECT_TRUE(All(a == a));
  for (int i = 0; i < 4; ++i) {
    Ints4 b = a;
    b[i] = 9;
    EXPECT_FALSE(All(a == b)) << i;
  }
}

TEST(LanesTest, BytesAreNumbersWithoutASign) {
  const Ints4 numbers = ToInts(Bytes4{0, 1, 128, 255});
  EXPECT_EQ(numbers[0], 0);
  EXPECT_EQ(numbers[2], 128);
  EXPECT_EQ(numbers[3], 255);
}

}  // namespace
}  // namespace semantic_slam
