#include "semantic_slam/network_evaluation/box_matching.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// 10 px square; shifted by d it overlaps another with an IoU of (10 - d) / (10 + d).
cv::Rect2f SquareAt(float x) {
  return {x, 0.0f, 10.0f, 10.0f};
}

TEST(BoxMatchingTest, TheSurestChoosesFirstAndTakesWhatItOverlapsMost) {
  // Both found ones overlap the first true box most; the second has to make do with the other.
  EXPECT_EQ(MatchInOrder({SquareAt(0), SquareAt(3)}, {SquareAt(1), SquareAt(0)}, 0.5),
            (std::vector<int>{0, 1}));
}

TEST(BoxMatchingTest, ATrueBoxIsFoundOnce) {
  EXPECT_EQ(MatchInOrder({SquareAt(0)}, {SquareAt(0), SquareAt(0)}, 0.5),
            (std::vector<int>{0, -1}));
}

TEST(BoxMatchingTest, TheLeastOverlapCounts) {
  // Half of a box of 10 x 10 inside one of 10 x 20: exactly 0.5.
  const cv::Rect2f tall(0.0f, 0.0f, 10.0f, 20.0f);
  EXPECT_EQ(MatchInOrder({tall}, {SquareAt(0)}, 0.5), (std::vector<int>{0}));
  EXPECT_EQ(MatchInOrder({tall}, {SquareAt(0)}, 0.51), (std::vector<int>{-1}));
}

TEST(BoxMatchingTest, OfEqualOverlapsTheFirstIsTaken) {
  EXPECT_EQ(MatchInOrder({SquareAt(2), SquareAt(-2)}, {SquareAt(0)}, 0.5), (std::vector<int>{0}));
}

TEST(BoxMatchingTest, NothingMatchesNothing) {
  EXPECT_EQ(MatchInOrder({}, {SquareAt(0)}, 0.5), (std::vector<int>{-1}));
  EXPECT_TRUE(MatchInOrder({SquareAt(0)}, {}, 0.5).empty());
}

TEST(CountBoxesTest, TellsConfusionsFromBackground) {
  ConfusionMatrix matrix(2);
  const std::vector<ClassBox> truth{
      {0, 1.0f, SquareAt(0)}, {0, 1.0f, SquareAt(100)}, {1, 1.0f, SquareAt(200)}};
  const std::vector<ClassBox> found{{0, 0.9f, SquareAt(1)},     // right
                                    {1, 0.8f, SquareAt(101)},   // a 0 taken for a 1
                                    {1, 0.7f, SquareAt(300)}};  // background taken for a 1
  CountBoxes(truth, found, 0.5, matrix);
  EXPECT_EQ(matrix.count(0, 0), 1);
  EXPECT_EQ(matrix.count(0, 1), 1);
  EXPECT_EQ(matrix.count(1, matrix.none()), 1);  // not found
  EXPECT_EQ(matrix.count(matrix.none(), 1), 1);
  EXPECT_EQ(matrix.count(matrix.none(), matrix.none()), 0);
}

TEST(CountBoxesTest, TheRightClassGoesBeforeTheLargerOverlap) {
  ConfusionMatrix matrix(2);
  CountBoxes({{0, 1.0f, SquareAt(0)}}, {{1, 0.9f, SquareAt(0)}, {0, 0.8f, SquareAt(2)}}, 0.5,
             matrix);
  EXPECT_EQ(matrix.count(0, 0), 1);
  EXPECT_EQ(matrix.count(0, 1), 0);
  EXPECT_EQ(matrix.count(matrix.none(), 1), 1);
}

TEST(PassOverOptionalTest, ABoxOnAnOptionalObjectIsLeftOut) {
  const cv::Rect2f on_truth(0.5f, 0.0f, 10.0f, 10.0f), on_optional(1.5f, 0.0f, 10.0f, 10.0f),
      elsewhere(20.0f, 0.0f, 10.0f, 10.0f);
  const std::vector<ClassBox> truth = {{0, 1.0f, {0.0f, 0.0f, 10.0f, 10.0f}}};
  const std::vector<ClassBox> found = {
      {0, 0.9f, on_truth}, {0, 0.8f, on_optional}, {1, 0.7f, elsewhere}};
  const auto kept = PassOverOptional(truth, {{2.0f, 0.0f, 10.0f, 10.0f}}, found, 0.5);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0].box, on_truth);
  EXPECT_EQ(kept[1].box, elsewhere);
  EXPECT_EQ(PassOverOptional(truth, {}, found, 0.5).size(), 3u);
}

}  // namespace
}  // namespace semantic_slam
