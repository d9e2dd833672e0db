#include "semantic_slam/common/duration_histogram.h"

#include <sstream>
#include <thread>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(DurationHistogramTest, EmptyIsZero) {
  const DurationHistogram histogram;
  EXPECT_EQ(histogram.count(), 0);
  EXPECT_EQ(histogram.QuantileMs(0.5), 0.0);
  EXPECT_EQ(histogram.mean_ms(), 0.0);
}

TEST(DurationHistogramTest, QuantilesAreWithinOnePercent) {
  DurationHistogram histogram;
  for (int i = 1; i <= 1000; ++i) histogram.Add(0.1 * i);  // 0.1 to 100 ms
  EXPECT_NEAR(histogram.QuantileMs(0.0), 0.1, 0.001);
  EXPECT_NEAR(histogram.QuantileMs(0.5), 50.0, 0.5);
  EXPECT_NEAR(histogram.QuantileMs(0.95), 95.0, 0.95);
  EXPECT_NEAR(histogram.QuantileMs(1.0), 100.0, 1.0);
  EXPECT_NEAR(histogram.mean_ms(), 50.05, 1e-9);
}

TEST(DurationHistogramTest, OfTwoTheMedianIsTheSmaller) {
  DurationHistogram histogram;
  histogram.Add(10.0);
  histogram.Add(1000.0);
  EXPECT_NEAR(histogram.QuantileMs(0.5), 10.0, 0.1);
}

TEST(DurationHistogramTest, TakesAnyDuration) {
  DurationHistogram histogram;
  for (const double ms : {-1.0, 0.0, 1e-9, 1e12}) histogram.Add(ms);
  EXPECT_EQ(histogram.count(), 4);
  EXPECT_LT(histogram.QuantileMs(0.5), 0.002);
  EXPECT_GT(histogram.QuantileMs(1.0), 3.6e6);  // an hour and more share the last bucket
}

TEST(StageTimerTest, CountsStagesByNameFromAnyThread) {
  StageTimer timer;
  std::thread other([&] {
    for (int i = 0; i < 1000; ++i) timer.Add("pose", 2.0);
  });
  for (int i = 0; i < 1000; ++i) timer.Add("features", 1.0);
  other.join();
  { const StageTimer::Scope scope(timer, "pose"); }
  const auto timings = timer.Timings();
  ASSERT_EQ(timings.size(), 2u);
  EXPECT_EQ(timings[0].stage, "features");
  EXPECT_EQ(timings[0].count, 1000);
  EXPECT_EQ(timings[1].count, 1001);
  EXPECT_NEAR(timings[1].p95_ms, 2.0, 0.02);
}

TEST(StageTimerTest, WritesTheContractsCsv) {
  std::ostringstream csv;
  WriteTimingCsv({{"pose", 3, 1.25, 10.0}}, csv);
  EXPECT_EQ(csv.str(), "stage,count,median_ms,p95_ms\npose,3,1.250,10.000\n");
}

}  // namespace
}  // namespace semantic_slam
