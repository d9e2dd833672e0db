#include "semantic_slam/features/descriptor.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// The first `count` of the 256 bits set: the distance of two of these is the difference of counts.
Descriptor WithBits(int count) {
  Descriptor descriptor{};
  for (int bit = 0; bit < count; ++bit) descriptor[bit / 64] |= std::uint64_t{1} << (bit % 64);
  return descriptor;
}

TEST(HammingDistanceTest, CountsTheBitsThatDiffer) {
  EXPECT_EQ(HammingDistance(WithBits(0), WithBits(0)), 0);
  EXPECT_EQ(HammingDistance(WithBits(0), WithBits(256)), kMaxDescriptorDistance);
  EXPECT_EQ(HammingDistance(WithBits(60), WithBits(200)), 140);
  EXPECT_EQ(HammingDistance(WithBits(200), WithBits(60)), 140);
}

TEST(HammingDistanceTest, EveryWordCounts) {
  for (int word = 0; word < 4; ++word) {
    Descriptor descriptor{};
    descriptor[word] = std::uint64_t{1} << 63 | 1;
    EXPECT_EQ(HammingDistance(descriptor, Descriptor{}), 2) << word;
  }
}

TEST(MedianDescriptorTest, IsTheOneInTheMiddleOfTheCrowd) {
  // Median distance of 11 to {0, 10, 11, 12, 200} is 1; of 10 and 12 it is 2, of the others more.
  EXPECT_EQ(
      MedianDescriptor({WithBits(200), WithBits(10), WithBits(0), WithBits(11), WithBits(12)}), 3u);
}

TEST(MedianDescriptorTest, IsNotDraggedAwayByWrongMatches) {
  // The sums of distances favour 100, which nothing is near to; the medians favour the crowd at 0.
  EXPECT_EQ(MedianDescriptor({WithBits(100), WithBits(2), WithBits(1), WithBits(0), WithBits(250),
                              WithBits(256)}),
            2u);
}

TEST(MedianDescriptorTest, TiesGoToTheLowestIndex) {
  EXPECT_EQ(MedianDescriptor({WithBits(7)}), 0u);
  EXPECT_EQ(MedianDescriptor({WithBits(7), WithBits(100)}), 0u);
  EXPECT_EQ(MedianDescriptor({WithBits(250), WithBits(7), WithBits(7), WithBits(7)}), 1u);
}

}  // namespace
}  // namespace semantic_slam
