#include "semantic_slam/network_evaluation/segmentation_score.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr LabelId kChair = 3, kStool = 4, kTable = 7, kWall = 1, kSofa = 9;

// Chair (stools count as chairs), table, sofa; walls do not count.
ClassList Classes() {
  ClassList classes;
  classes.Add("chair", kChair);
  classes.Add("table", kTable);
  classes.Add("sofa", kSofa);
  classes.of_label[kStool] = 0;
  return classes;
}

SegmentationScore Score(std::vector<LabelId> truth, std::vector<LabelId> predicted) {
  ConfusionMatrix matrix(3);
  CountPixels(cv::Mat(1, static_cast<int>(truth.size()), CV_8UC1, truth.data()),
              cv::Mat(1, static_cast<int>(predicted.size()), CV_8UC1, predicted.data()), Classes(),
              matrix);
  return ScoreSegmentation(matrix);
}

TEST(SegmentationScoreTest, IsWhatOneCountsByHand) {
  // Of six chair pixels four are right (one as a stool), one is called table, one wall; of two
  // table pixels one is right, one is called chair. The wall does not count, whatever it is called.
  const SegmentationScore score =
      Score({kChair, kChair, kChair, kStool, kChair, kChair, kTable, kTable, kWall, kWall},
            {kChair, kChair, kStool, kChair, kTable, kWall, kTable, kChair, kChair, kWall});
  EXPECT_EQ(score.pixels, 8);
  EXPECT_DOUBLE_EQ(score.pixel_accuracy, 5.0 / 8.0);
  EXPECT_DOUBLE_EQ(score.classes[0].iou, 4.0 / 7.0);  // 6 true, 5 predicted, 4 both
  EXPECT_DOUBLE_EQ(score.classes[0].precision, 4.0 / 5.0);
  EXPECT_DOUBLE_EQ(score.classes[0].recall, 4.0 / 6.0);
  EXPECT_DOUBLE_EQ(score.classes[0].pixel_share, 6.0 / 8.0);
  EXPECT_DOUBLE_EQ(score.classes[1].iou, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(score.mean_class_accuracy, (4.0 / 6.0 + 1.0 / 2.0) / 2.0);
  EXPECT_DOUBLE_EQ(score.mean_iou, (4.0 / 7.0 + 1.0 / 3.0) / 2.0);
  EXPECT_DOUBLE_EQ(score.frequency_weighted_iou, 0.75 * 4.0 / 7.0 + 0.25 * 1.0 / 3.0);
}

TEST(SegmentationScoreTest, AbsentClassesHaveNoScoreAndNoSayInMeans) {
  const SegmentationScore score = Score({kChair, kChair}, {kChair, kChair});
  EXPECT_TRUE(std::isnan(score.classes[1].iou));
  EXPECT_TRUE(std::isnan(score.classes[1].precision));
  EXPECT_TRUE(std::isnan(score.classes[1].recall));
  EXPECT_EQ(score.classes[1].pixel_share, 0.0);
  EXPECT_EQ(score.mean_iou, 1.0);
  EXPECT_EQ(score.mean_class_accuracy, 1.0);
}

TEST(SegmentationScoreTest, ClassesThatAreOnlyPredictedScoreZeroButHaveNoSayInMeans) {
  const SegmentationScore score = Score({kChair, kChair}, {kChair, kSofa});
  EXPECT_EQ(score.classes[2].iou, 0.0);
  EXPECT_EQ(score.classes[2].precision, 0.0);
  EXPECT_TRUE(std::isnan(score.classes[2].recall));
  EXPECT_EQ(score.mean_iou, 0.5);
}

TEST(SegmentationScoreTest, NothingToCountIsNoNumber) {
  for (const SegmentationScore& score : {Score({kWall, 255}, {kChair, kWall}), Score({}, {})}) {
    EXPECT_EQ(score.pixels, 0);
    EXPECT_TRUE(std::isnan(score.pixel_accuracy));
    EXPECT_TRUE(std::isnan(score.mean_class_accuracy));
    EXPECT_TRUE(std::isnan(score.mean_iou));
    EXPECT_TRUE(std::isnan(score.frequency_weighted_iou));
  }
}

}  // namespace
}  // namespace semantic_slam
