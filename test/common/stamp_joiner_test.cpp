#include "semantic_slam/common/stamp_joiner.h"

#include <string>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

using Joiner = StampJoiner<std::string, int>;

Stamp Ms(std::int64_t ms) {
  return Stamp{ms * 1'000'000};
}

TEST(StampJoinerTest, JoinsInEitherOrder) {
  Joiner joiner(5, 5);
  EXPECT_FALSE(joiner.AddSource(Ms(10), "a"));
  EXPECT_FALSE(joiner.AddSource(Ms(20), "b"));
  const auto late = joiner.AddResult(Ms(10), 1);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->source, "a");
  EXPECT_EQ(late->result, 1);

  EXPECT_FALSE(joiner.AddResult(Ms(30), 3));
  const auto early = joiner.AddSource(Ms(30), "c");
  ASSERT_TRUE(early);
  EXPECT_EQ(early->source, "c");
  EXPECT_EQ(early->result, 3);
  EXPECT_EQ(joiner.unjoined_results(), 0u);
}

TEST(StampJoinerTest, ForgetsWhatIsOlderThanAPair) {
  Joiner joiner(5, 5);
  joiner.AddSource(Ms(10), "a");
  joiner.AddResult(Ms(15), 1);
  joiner.AddSource(Ms(20), "b");
  ASSERT_TRUE(joiner.AddResult(Ms(20), 2));
  EXPECT_EQ(joiner.unjoined_results(), 1u);
  EXPECT_FALSE(joiner.AddResult(Ms(10), 1));
}

TEST(StampJoinerTest, HoldsNoMoreThanItMay) {
  Joiner joiner(3, 2);
  for (int i = 0; i < 10; ++i) joiner.AddSource(Ms(10 * i), "x");
  EXPECT_FALSE(joiner.AddResult(Ms(60), 6));
  EXPECT_TRUE(joiner.AddResult(Ms(70), 7));
  EXPECT_EQ(joiner.unjoined_results(), 1u);
  for (int i = 11; i < 15; ++i) joiner.AddResult(Ms(10 * i + 5), i);
  EXPECT_EQ(joiner.unjoined_results(), 3u);
}

TEST(StampJoinerTest, BeginsAnewWhenStampsJumpBack) {
  Joiner joiner(5, 5);
  joiner.AddSource(Ms(5000), "old");
  joiner.AddResult(Ms(5010), 1);
  joiner.AddSource(Ms(1000), "new");
  EXPECT_EQ(joiner.unjoined_results(), 1u);
  EXPECT_TRUE(joiner.AddResult(Ms(1000), 3));
}

TEST(StampJoinerTest, TheLaterOfTwoWithOneStampCounts) {
  Joiner joiner(5, 5);
  joiner.AddSource(Ms(10), "first");
  joiner.AddSource(Ms(10), "second");
  EXPECT_EQ(joiner.AddResult(Ms(10), 1)->source, "second");
}

}  // namespace
}  // namespace semantic_slam
