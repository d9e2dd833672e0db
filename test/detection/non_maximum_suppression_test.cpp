#include "semantic_slam/detection/non_maximum_suppression.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(NonMaximumSuppressionTest, KeepsTheSurestOfThoseThatOverlap) {
  // The first two share a third of their union, the third stands alone.
  const std::vector<ScoredBox> boxes{
      {{0, 0, 2, 2}, 0.5f, 0}, {{1, 0, 2, 2}, 0.9f, 0}, {{10, 0, 2, 2}, 0.7f, 0}};
  EXPECT_EQ(SuppressNonMaxima(boxes, 0.3), (std::vector<int>{1, 2}));
  EXPECT_EQ(SuppressNonMaxima(boxes, 0.4), (std::vector<int>{1, 2, 0}));
}

TEST(NonMaximumSuppressionTest, GroupsDoNotTouchEachOther) {
  const std::vector<ScoredBox> boxes{
      {{0, 0, 2, 2}, 0.5f, 0}, {{0, 0, 2, 2}, 0.9f, 1}, {{0, 0, 2, 2}, 0.7f, 0}};
  EXPECT_EQ(SuppressNonMaxima(boxes, 0.5), (std::vector<int>{1, 2}));
}

TEST(NonMaximumSuppressionTest, WhatIsSuppressedSuppressesNothing) {
  // A chain: each overlaps the next by a third, the ends do not meet.
  const std::vector<ScoredBox> boxes{
      {{0, 0, 2, 2}, 0.9f, 0}, {{1, 0, 2, 2}, 0.8f, 0}, {{2, 0, 2, 2}, 0.7f, 0}};
  EXPECT_EQ(SuppressNonMaxima(boxes, 0.3), (std::vector<int>{0, 2}));
}

TEST(NonMaximumSuppressionTest, OfEqualScoresTheFirstWins) {
  const std::vector<ScoredBox> boxes{
      {{0, 0, 2, 2}, 0.5f, 0}, {{0, 0, 2, 2}, 0.5f, 0}, {{5, 0, 2, 2}, 0.5f, 0}};
  EXPECT_EQ(SuppressNonMaxima(boxes, 0.5), (std::vector<int>{0, 2}));
}

TEST(NonMaximumSuppressionTest, AtAnOverlapOfOneNothingGoes) {
  const std::vector<ScoredBox> boxes{{{0, 0, 2, 2}, 0.5f, 0}, {{0, 0, 2, 2}, 0.5f, 0}};
  EXPECT_EQ(SuppressNonMaxima(boxes, 1.0).size(), 2u);
  EXPECT_TRUE(SuppressNonMaxima({}, 0.5).empty());
}

}  // namespace
}  // namespace semantic_slam
