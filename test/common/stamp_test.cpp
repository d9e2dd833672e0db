#include "semantic_slam/common/stamp.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(StampTest, ParsesExactly) {
  EXPECT_EQ(Stamp::Parse("1305031453.359684")->ns, 1305031453359684000);
  EXPECT_EQ(Stamp::Parse("1305031449.7996")->ns, 1305031449799600000);
  EXPECT_EQ(Stamp::Parse("12")->ns, 12000000000);
  EXPECT_EQ(Stamp::Parse("0.000000001")->ns, 1);
  EXPECT_EQ(Stamp::Parse("5.")->ns, 5000000000);
}

TEST(StampTest, RefusesEverythingElse) {
  for (const char* text : {"", ".", ".5", "abc", "-1.0", "+1", "1e9", "1.2.3", "12345678901",
                           "1.0000000001", "9999999999", " 1", "1 ", "nan", "1,5"}) {
    EXPECT_FALSE(Stamp::Parse(text)) << text;
  }
}

TEST(StampTest, WritesSixDecimalsOrNineWhereSixWouldLose) {
  EXPECT_EQ(ToString(Stamp{1305031453359684000}), "1305031453.359684");
  EXPECT_EQ(ToString(Stamp{1305031453359684001}), "1305031453.359684001");
  EXPECT_EQ(ToString(Stamp{0}), "0.000000");
  EXPECT_EQ(ToString(Stamp{-1500000000}), "-1.500000");
}

TEST(StampTest, ReadsBackWhatItWrites) {
  for (const std::int64_t ns : {0L, 1L, 999999999L, 1305031453359684000L, 1305031453359684001L}) {
    EXPECT_EQ(Stamp::Parse(ToString(Stamp{ns}))->ns, ns);
  }
}

TEST(StampTest, FromSecondsRoundsToTheNearestNanosecond) {
  EXPECT_EQ(Stamp::FromSeconds(0.1).ns, 100000000);
  EXPECT_EQ(Stamp::FromSeconds(-0.25).ns, -250000000);
}

TEST(StampTest, SecondsBetweenIsSigned) {
  EXPECT_DOUBLE_EQ(SecondsBetween(Stamp{1'000'000'000}, Stamp{3'500'000'000}), 2.5);
  EXPECT_DOUBLE_EQ(SecondsBetween(Stamp{3'500'000'000}, Stamp{1'000'000'000}), -2.5);
}

}  // namespace
}  // namespace semantic_slam
