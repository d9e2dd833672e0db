#include "semantic_slam/network_evaluation/detection_score.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kThreshold = 0.5;

cv::Rect2f SquareAt(float x) {
  return {x, 0.0f, 10.0f, 10.0f};
}

ClassBox Truth(int class_index, float x) {
  return {class_index, 1.0f, SquareAt(x)};
}

// Two images of two classes. Of class 0 there are three true boxes, of which two are found, one of
// them with little confidence, and there is one too many; of class 1 there is one, not found.
DetectionScore TwoImages() {
  DetectionScore score(3, kThreshold);
  score.Add({Truth(0, 0), Truth(0, 100)}, {{0, 0.9f, SquareAt(0)}, {0, 0.3f, SquareAt(100)}});
  score.Add({Truth(0, 0), Truth(1, 200)}, {{0, 0.8f, SquareAt(50)}});
  return score;
}

TEST(DetectionScoreTest, AveragePrecisionPerClassAndMean) {
  const DetectionScore score = TwoImages();
  // Hit, miss, hit of three: precisions 1, 1/2, 2/3 at recalls 1/3, 1/3, 2/3.
  const double ap = (1.0 + 2.0 / 3.0) / 3.0;
  EXPECT_EQ(score.OfClass(0).truths, 3);
  EXPECT_DOUBLE_EQ(score.OfClass(0).ap50, ap);
  EXPECT_DOUBLE_EQ(score.OfClass(0).ap50_95, ap);  // the found boxes are exact
  EXPECT_EQ(score.OfClass(1).ap50, 0.0);
  EXPECT_TRUE(std::isnan(score.OfClass(2).ap50));  // absent
  EXPECT_DOUBLE_EQ(score.MeanAp50(), ap / 2.0);    // over the two that there are
}

TEST(DetectionScoreTest, RatesAtTheThreshold) {
  const DetectionScore score = TwoImages();
  const ClassDetectionScore of_class = score.OfClass(0);
  EXPECT_EQ(of_class.rates.hits, 1);
  EXPECT_EQ(of_class.rates.extras, 1);
  EXPECT_EQ(of_class.rates.misses, 2);
  const OperatingPoint point = score.At(kThreshold);
  EXPECT_EQ(point.rates.hits, 1);
  EXPECT_EQ(point.rates.extras, 1);
  EXPECT_EQ(point.rates.misses, 3);
  EXPECT_DOUBLE_EQ(point.mean_class_precision, 0.5);             // class 1 finds nothing
  EXPECT_DOUBLE_EQ(point.mean_class_recall, (1.0 / 3.0) / 2.0);  // and is not found
}

TEST(DetectionScoreTest, BestF1IsSoughtOverAllThresholds) {
  // F1 of all four true boxes: 2/(4 + 1) at 0.9, 2/(4 + 2) at 0.8, 4/(4 + 3) at 0.3.
  const auto best = TwoImages().AtBestF1();
  ASSERT_TRUE(best);
  EXPECT_DOUBLE_EQ(best->threshold, static_cast<double>(0.3f));
  EXPECT_DOUBLE_EQ(best->rates.f1(), 4.0 / 7.0);
}

TEST(DetectionScoreTest, OfEqualF1TheHigherThresholdIsTaken) {
  DetectionScore score(1, kThreshold);
  // 2/(2 + 1) = 2/3 at 0.9; a miss and another hit: 4/(2 + 4) = 2/3 at 0.6 with four found.
  score.Add({Truth(0, 0), Truth(0, 100)}, {{0, 0.9f, SquareAt(0)},
                                           {0, 0.8f, SquareAt(300)},
                                           {0, 0.7f, SquareAt(500)},
                                           {0, 0.6f, SquareAt(100)}});
  EXPECT_DOUBLE_EQ(score.AtBestF1()->threshold, static_cast<double>(0.9f));
}

TEST(DetectionScoreTest, LooseBoxesCountOnlyAtLowOverlap) {
  DetectionScore score(1, kThreshold);
  score.Add({Truth(0, 0)}, {{0, 0.9f, SquareAt(1)}});  // IoU 9/11 = 0.818: 0.5 to 0.8 of ten steps
  EXPECT_EQ(score.MeanAp50(), 1.0);
  EXPECT_DOUBLE_EQ(score.MeanAp50To95(), 0.7);
}

TEST(DetectionScoreTest, ReturnsTheRatesOfTheImage) {
  DetectionScore score(2, kThreshold);
  const DetectionRates rates =
      score.Add({Truth(0, 0), Truth(1, 100)},
                {{0, 0.9f, SquareAt(0)}, {0, 0.6f, SquareAt(0)}, {1, 0.4f, SquareAt(100)}});
  EXPECT_EQ(rates.hits, 1);
  EXPECT_EQ(rates.extras, 1);
  EXPECT_EQ(rates.misses, 1);
  EXPECT_TRUE(std::isnan(score.Add({}, {}).f1()));
}

TEST(DetectionScoreTest, ABoxOfAnotherClassIsNoHit) {
  DetectionScore score(2, kThreshold);
  score.Add({Truth(0, 0)}, {{1, 0.9f, SquareAt(0)}});
  EXPECT_EQ(score.OfClass(0).ap50, 0.0);
  EXPECT_EQ(score.At(kThreshold).rates.extras, 1);
}

TEST(DetectionScoreTest, NothingFoundIsZeroAndNothingThereIsNoNumber) {
  DetectionScore blind(1, kThreshold);
  blind.Add({Truth(0, 0)}, {});
  EXPECT_EQ(blind.MeanAp50(), 0.0);
  EXPECT_FALSE(blind.AtBestF1());
  EXPECT_TRUE(std::isnan(blind.At(kThreshold).rates.precision()));
  EXPECT_TRUE(std::isnan(blind.At(kThreshold).mean_class_precision));
  const DetectionScore empty(1, kThreshold);
  EXPECT_TRUE(std::isnan(empty.MeanAp50()));
  EXPECT_TRUE(std::isnan(empty.MeanAp50To95()));
  EXPECT_FALSE(empty.AtBestF1());
}

}  // namespace
}  // namespace semantic_slam
