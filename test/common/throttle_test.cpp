#include "semantic_slam/common/throttle.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Stamp Milliseconds(std::int64_t ms) { return Stamp{ms * 1'000'000}; }

TEST(ThrottleTest, IsDueOncePerPeriod) {
  Throttle throttle(0.1);
  EXPECT_TRUE(throttle.IsDue(Milliseconds(1000)));
  EXPECT_FALSE(throttle.IsDue(Milliseconds(1000)));
  EXPECT_FALSE(throttle.IsDue(Milliseconds(1099)));
  EXPECT_TRUE(throttle.IsDue(Milliseconds(1100)));
  EXPECT_FALSE(throttle.IsDue(Milliseconds(1199)));
}

TEST(ThrottleTest, IsDueWhenStampsHaveJumpedBack) {
  Throttle throttle(10.0);
  EXPECT_TRUE(throttle.IsDue(Milliseconds(5000)));
  EXPECT_TRUE(throttle.IsDue(Milliseconds(4000)));
  EXPECT_FALSE(throttle.IsDue(Milliseconds(5000)));
}

TEST(ThrottleTest, WithoutAPeriodIsAlwaysDue) {
  Throttle throttle(0.0);
  EXPECT_TRUE(throttle.IsDue(Milliseconds(1)));
  EXPECT_TRUE(throttle.IsDue(Milliseconds(1)));
}

}  // namespace
}  // namespace semantic_slam
