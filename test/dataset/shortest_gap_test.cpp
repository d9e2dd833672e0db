#include "semantic_slam/dataset/shortest_gap.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr std::int64_t kStartNs = 1'000'000'000;

TEST(ShortestGapTest, SaysNothingBeforeTenGaps) {
  ShortestGap gap;
  for (int i = 0; i < 10; ++i) {
    gap.Add({kStartNs + 33 * i});
    EXPECT_EQ(gap.ns(), std::nullopt) << i << " gaps";
  }
  gap.Add({kStartNs + 330});
  EXPECT_EQ(gap.ns(), 33);
}

TEST(ShortestGapTest, IsTheShortestAndNotTheUsualOne) {
  ShortestGap gap;
  std::int64_t ns = kStartNs;
  for (const int step : {33, 66, 33, 35, 31, 33, 33, 99, 33, 33, 33}) gap.Add({ns += step});
  EXPECT_EQ(gap.ns(), 31);
}

TEST(ShortestGapTest, ForgetsAGapAfterAHundredOthers) {
  ShortestGap gap;
  std::int64_t ns = kStartNs;
  gap.Add({ns});
  gap.Add({ns += 5});
  for (int i = 0; i < 99; ++i) gap.Add({ns += 33});
  EXPECT_EQ(gap.ns(), 5);
  gap.Add({ns += 33});
  EXPECT_EQ(gap.ns(), 33);
}

}  // namespace
}  // namespace semantic_slam
