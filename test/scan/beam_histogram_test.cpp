#include "semantic_slam/scan/beam_histogram.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr float kMaxRangeM = 4.0f;
constexpr float kBinM = 0.05f;  // tolerance of what is counted by bins

float NoDepth(float) {
  return 0.0f;
}
float TenCentimetres(float) {
  return 0.1f;
}

TEST(BeamHistogramTest, TakesTheMeanOfTheNearestSurface) {
  BeamHistogram histogram(2, kMaxRangeM);
  for (const float range_m : {2.01f, 2.02f, 2.03f, 3.0f, 3.0f, 3.0f}) histogram.AddHit(1, range_m);
  EXPECT_NEAR(histogram.NearestSurface(1, 3, TenCentimetres), 2.02f, 1e-5f);  // rounding
  EXPECT_TRUE(std::isnan(histogram.NearestSurface(0, 1, TenCentimetres)));
}

TEST(BeamHistogramTest, IgnoresHitsThatNoOthersSupport) {
  BeamHistogram histogram(1, kMaxRangeM);
  for (const float range_m : {1.0f, 1.5f, 2.02f, 2.03f}) histogram.AddHit(0, range_m);
  EXPECT_NEAR(histogram.NearestSurface(0, 2, NoDepth), 2.025f, 1e-5f);  // rounding
  EXPECT_TRUE(std::isnan(histogram.NearestSurface(0, 3, NoDepth)));
}

TEST(BeamHistogramTest, KeepsAHitAtTheMaximumRange) {
  BeamHistogram histogram(1, kMaxRangeM);
  histogram.AddHit(0, kMaxRangeM);
  EXPECT_FLOAT_EQ(histogram.NearestSurface(0, 1, TenCentimetres), kMaxRangeM);
}

TEST(BeamHistogramTest, IsFreeWhereEnoughRaysAre) {
  BeamHistogram histogram(1, kMaxRangeM);
  for (int pixel = 0; pixel < 3; ++pixel) {
    histogram.AddFree(0, {0.0f, 2.0f + 0.5f * static_cast<float>(pixel)}, 1.0f);
  }
  EXPECT_FLOAT_EQ(histogram.FreeStretch(0, 3, 0.0f).to_m, 2.0f);
  EXPECT_NEAR(histogram.FreeStretch(0, 2, 0.0f).to_m, 2.5f, kBinM);
  EXPECT_NEAR(histogram.FreeStretch(0, 1, 0.0f).to_m, 3.0f, kBinM);
}

TEST(BeamHistogramTest, IsFreeWhereEnoughHeightWasSeen) {
  // Two pixels that stand for 0.15 m of height per metre: 0.3 m are seen from 2 m on.
  BeamHistogram histogram(1, kMaxRangeM);
  histogram.AddFree(0, {0.0f, 3.0f}, 0.1f);
  histogram.AddFree(0, {0.0f, kMaxRangeM}, 0.05f);
  const RangeInterval stretch = histogram.FreeStretch(0, 1, 0.3f);
  EXPECT_NEAR(stretch.from_m, 2.0f, kBinM);
  EXPECT_NEAR(stretch.to_m, 3.0f, kBinM) << "beyond, one of them alone sees too little";
}

TEST(BeamHistogramTest, IsFreeToTheMaximumRangeExactly) {
  BeamHistogram histogram(1, 4.03f);  // not a whole number of bins
  histogram.AddFree(0, {0.0f, 4.03f}, 1.0f);
  EXPECT_EQ(histogram.FreeStretch(0, 1, 0.0f).to_m, 4.03f);
}

TEST(BeamHistogramTest, BeginsWhereRaysEnterTheBand) {
  BeamHistogram histogram(1, kMaxRangeM);
  histogram.AddFree(0, {1.0f, 3.0f}, 1.0f);
  const RangeInterval stretch = histogram.FreeStretch(0, 1, 0.0f);
  EXPECT_NEAR(stretch.from_m, 1.0f, kBinM);
  EXPECT_NEAR(stretch.to_m, 3.0f, kBinM);
}

TEST(BeamHistogramTest, EndsWhereNothingWasSeen) {
  BeamHistogram histogram(1, kMaxRangeM);
  histogram.AddFree(0, {0.0f, 1.0f}, 1.0f);
  histogram.AddFree(0, {2.0f, 3.0f}, 1.0f);
  EXPECT_NEAR(histogram.FreeStretch(0, 1, 0.0f).to_m, 1.0f, kBinM);
  const RangeInterval none = BeamHistogram(1, kMaxRangeM).FreeStretch(0, 1, 0.0f);
  EXPECT_GE(none.from_m, none.to_m);
}

}  // namespace
}  // namespace semantic_slam
