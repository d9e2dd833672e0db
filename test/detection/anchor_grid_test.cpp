#include "semantic_slam/detection/anchor_grid.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr int kColumns = 7;
const std::vector<cv::Size2f> kAnchors{{10.0f, 20.0f}, {30.0f, 40.0f}};

// A 2 x 3 grid that holds, at anchor a, row y, cell x and column c, a thousand and its indices.
float ValueAt(int a, int y, int x, int c) {
  return 1000.0f * a + 100.0f * y + 10.0f * x + 0.1f * c;
}

TEST(AnchorGridTest, SaysWhatFits) {
  const AnchorGrid grid(8.0f, kAnchors, kColumns);
  EXPECT_TRUE(grid.Fits({1, 2, 5, 6, 7}));
  EXPECT_TRUE(grid.Fits({1, 14, 5, 6}));
  EXPECT_FALSE(grid.Fits({1, 3, 5, 6, 7}));
  EXPECT_FALSE(grid.Fits({1, 2, 5, 6, 8}));
  EXPECT_FALSE(grid.Fits({1, 21, 5, 6}));
  EXPECT_FALSE(grid.Fits({2, 14, 5, 6}));
  EXPECT_FALSE(grid.Fits({1, 60, 7}));
}

TEST(AnchorGridTest, BothLayoutsGiveTheSameRows) {
  cv::Mat five({1, 2, 2, 3, kColumns}, CV_32F), four({1, 2 * kColumns, 2, 3}, CV_32F);
  for (int a = 0; a < 2; ++a) {
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 3; ++x) {
        for (int c = 0; c < kColumns; ++c) {
          const int at_five[] = {0, a, y, x, c}, at_four[] = {0, a * kColumns + c, y, x};
          five.at<float>(at_five) = four.at<float>(at_four) = ValueAt(a, y, x, c);
        }
      }
    }
  }
  const AnchorGrid grid(8.0f, kAnchors, kColumns);
  const cv::Mat rows = grid.Decode(five);
  EXPECT_EQ(rows.rows, 2 * 2 * 3);
  EXPECT_EQ(cv::norm(rows, grid.Decode(four), cv::NORM_INF), 0.0);
  // Anchors outermost, then rows, then cells; what follows the box is passed on.
  EXPECT_EQ(rows.at<float>(6 + 3 + 2, 6), ValueAt(1, 1, 2, 6));
}

TEST(AnchorGridTest, ZerosAreTheAnchorInTheMiddleOfItsCell) {
  const cv::Mat rows = AnchorGrid(8.0f, kAnchors, kColumns)
                           .Decode(cv::Mat({1, 2 * kColumns, 2, 3}, CV_32F, cv::Scalar(0)));
  const float* last = rows.ptr<float>(rows.rows - 1);
  EXPECT_FLOAT_EQ(last[0], 8.0f * 2.5f);
  EXPECT_FLOAT_EQ(last[1], 8.0f * 1.5f);
  EXPECT_FLOAT_EQ(last[2], 30.0f);
  EXPECT_FLOAT_EQ(last[3], 40.0f);
}

TEST(AnchorGridTest, ReachesHalfACellBeyondAndFourAnchorsWide) {
  const cv::Mat rows = AnchorGrid(8.0f, {{10.0f, 20.0f}}, kColumns)
                           .Decode(cv::Mat({1, kColumns, 1, 1}, CV_32F, cv::Scalar(100)));
  EXPECT_FLOAT_EQ(rows.at<float>(0, 0), 8.0f * 1.5f);
  EXPECT_FLOAT_EQ(rows.at<float>(0, 2), 40.0f);
}

}  // namespace
}  // namespace semantic_slam
