#include "semantic_slam/network_evaluation/confusion_picture.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// How many pixels have about that colour, BGR.
int Near(const cv::Mat& picture, const cv::Scalar& colour) {
  cv::Mat mask;
  cv::inRange(picture, colour - cv::Scalar::all(3), colour + cv::Scalar::all(3), mask);
  return cv::countNonZero(mask);
}

const cv::Scalar kRight(110, 140, 40), kWrong(60, 80, 200);
constexpr int kMostOfACell = 44 * 44 / 2;  // the rest is lettering and its rim

TEST(ConfusionPictureTest, FullCellsAreFilled) {
  ConfusionMatrix right(2);
  right.Add(0, 0, 10);
  EXPECT_GT(Near(DrawConfusion(right, {"chair", "table"}, "other", "t"), kRight), kMostOfACell);
  ConfusionMatrix wrong(2);
  wrong.Add(0, 1, 10);
  const cv::Mat picture = DrawConfusion(wrong, {"chair", "table"}, "other", "t");
  EXPECT_GT(Near(picture, kWrong), kMostOfACell);
  EXPECT_EQ(Near(picture, kRight), 0);
}

TEST(ConfusionPictureTest, GrowsWithTheClassesThatOccur) {
  ConfusionMatrix matrix(3);
  matrix.Add(0, 0);
  const std::vector<std::string> names{"chair", "table", "sofa"};
  const cv::Mat one = DrawConfusion(matrix, names, "other", "t");
  matrix.Add(1, 1);
  const cv::Mat two = DrawConfusion(matrix, names, "other", "t");
  matrix.Add(1, matrix.none());
  const cv::Mat with_other = DrawConfusion(matrix, names, "other", "t");
  EXPECT_EQ(two.size(), one.size() + cv::Size(44, 44));
  EXPECT_EQ(with_other.size(), two.size() + cv::Size(44, 0));
}

TEST(ConfusionPictureTest, DrawsAnEmptyMatrixAndAVeryLargeOne) {
  EXPECT_FALSE(DrawConfusion(ConfusionMatrix(2), {"a", "b"}, "other", "nothing").empty());
  ConfusionMatrix large(255);
  for (int c = 0; c < 255; ++c) large.Add(c, c);
  const cv::Mat picture =
      DrawConfusion(large, std::vector<std::string>(255, "a long name of a class"), "other", "t");
  EXPECT_LT(picture.cols, 4000);
}

}  // namespace
}  // namespace semantic_slam
