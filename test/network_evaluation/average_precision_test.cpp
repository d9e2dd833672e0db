#include "semantic_slam/network_evaluation/average_precision.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

double Ap(const std::vector<ScoredHit>& found, std::int64_t truths) {
  return AveragePrecision(PrecisionRecallCurve(found, truths), truths);
}

TEST(AveragePrecisionTest, IsTheAreaBelowTheEnvelope) {
  // Hit, miss, hit, miss, of three true boxes: precisions 1, 1/2, 2/3, 1/2 at recalls 1/3, 1/3,
  // 2/3, 2/3; the envelope is 1 up to 1/3, 2/3 up to 2/3, 0 behind.
  const std::vector<ScoredHit> found{{0.9f, true}, {0.8f, false}, {0.7f, true}, {0.6f, false}};
  EXPECT_DOUBLE_EQ(Ap(found, 3), (1.0 + 2.0 / 3.0) / 3.0);
}

TEST(AveragePrecisionTest, LaterPrecisionLiftsTheEnvelope) {
  // Miss, hit, hit of two: precisions 0, 1/2, 2/3; the envelope is 2/3 throughout.
  EXPECT_DOUBLE_EQ(Ap({{0.9f, false}, {0.8f, true}, {0.7f, true}}, 2), 2.0 / 3.0);
}

TEST(AveragePrecisionTest, PerfectIsOneAndNothingFoundIsZero) {
  EXPECT_EQ(Ap({{0.9f, true}, {0.3f, true}}, 2), 1.0);
  EXPECT_EQ(Ap({}, 2), 0.0);
  EXPECT_EQ(Ap({{0.9f, false}}, 2), 0.0);
}

TEST(AveragePrecisionTest, WithoutTrueBoxesThereIsNone) {
  EXPECT_TRUE(std::isnan(Ap({}, 0)));
  EXPECT_TRUE(std::isnan(Ap({{0.9f, false}}, 0)));
}

TEST(AveragePrecisionTest, OfEqualConfidencesTheOrderDoesNotMatter) {
  std::vector<ScoredHit> found{{0.9f, true}, {0.5f, false}, {0.5f, true}, {0.5f, false}};
  const double expected = 0.5 * 1.0 + 0.5 * 2.0 / 4.0;  // the three count together
  EXPECT_DOUBLE_EQ(Ap(found, 2), expected);
  std::swap(found[1], found[2]);
  EXPECT_DOUBLE_EQ(Ap(found, 2), expected);
  std::reverse(found.begin(), found.end());
  EXPECT_DOUBLE_EQ(Ap(found, 2), expected);
}

TEST(AveragePrecisionTest, CurveHasAPointPerConfidence) {
  const std::vector<CurvePoint> curve =
      PrecisionRecallCurve({{0.5f, false}, {0.9f, true}, {0.5f, true}}, 4);
  ASSERT_EQ(curve.size(), 2u);
  EXPECT_EQ(curve[0].confidence, 0.9f);
  EXPECT_EQ(curve[0].rates.hits, 1);
  EXPECT_EQ(curve[0].rates.misses, 3);
  EXPECT_EQ(curve[1].confidence, 0.5f);
  EXPECT_EQ(curve[1].rates.hits, 2);
  EXPECT_EQ(curve[1].rates.extras, 1);
  EXPECT_EQ(curve[1].rates.misses, 2);
}

TEST(DetectionRatesTest, AreThoseOfTheThesis) {
  const DetectionRates rates{6, 2, 4};
  EXPECT_DOUBLE_EQ(rates.precision(), 0.75);
  EXPECT_DOUBLE_EQ(rates.recall(), 0.6);
  EXPECT_DOUBLE_EQ(rates.f1(), 2.0 * 0.75 * 0.6 / (0.75 + 0.6));
}

TEST(DetectionRatesTest, WhatCannotBeCountedIsNoNumber) {
  EXPECT_TRUE(std::isnan(DetectionRates{}.f1()));
  EXPECT_TRUE(std::isnan((DetectionRates{0, 0, 3}).precision()));
  EXPECT_EQ((DetectionRates{0, 0, 3}).recall(), 0.0);
  EXPECT_EQ((DetectionRates{0, 0, 3}).f1(), 0.0);
  EXPECT_TRUE(std::isnan((DetectionRates{0, 3, 0}).recall()));
}

}  // namespace
}  // namespace semantic_slam
