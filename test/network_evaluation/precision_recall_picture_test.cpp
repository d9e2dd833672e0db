#include "semantic_slam/network_evaluation/precision_recall_picture.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

int ColouredPixels(const cv::Mat& picture) {
  std::vector<cv::Mat> channels;
  cv::split(picture, channels);
  cv::Mat difference;
  cv::absdiff(channels[2], channels[0], difference);
  return cv::countNonZero(difference > 60);
}

TEST(PrecisionRecallPictureTest, DrawsACurveForEveryClassWithTruth) {
  const cv::Rect2f box(0.0f, 0.0f, 10.0f, 10.0f);
  const std::vector<std::string> names{"chair", "table"};
  DetectionScore none(2, 0.5), one(2, 0.5), two(2, 0.5);
  for (DetectionScore* score : {&one, &two}) score->Add({{0, 1.0f, box}}, {{0, 0.9f, box}});
  const cv::Rect2f wrong(50.0f, 0.0f, 10.0f, 10.0f);
  two.Add({{1, 1.0f, box}}, {{1, 0.9f, wrong}, {1, 0.8f, box}});  // a curve elsewhere
  const int nothing = ColouredPixels(DrawPrecisionRecall(none, names));
  const int chair = ColouredPixels(DrawPrecisionRecall(one, names));
  const int both = ColouredPixels(DrawPrecisionRecall(two, names));
  EXPECT_EQ(nothing, 0);
  EXPECT_GT(chair, 100);  // at least the legend's square
  EXPECT_GT(both, chair + 100);
}

TEST(PrecisionRecallPictureTest, HasRoomForManyClasses) {
  DetectionScore score(60, 0.5);
  const cv::Rect2f box(0.0f, 0.0f, 10.0f, 10.0f);
  for (int c = 0; c < 60; ++c) score.Add({{c, 1.0f, box}}, {});
  EXPECT_FALSE(DrawPrecisionRecall(score, std::vector<std::string>(60, "name")).empty());
}

}  // namespace
}  // namespace semantic_slam
