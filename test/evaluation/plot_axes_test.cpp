#include "semantic_slam/evaluation/plot_axes.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

std::vector<std::string> Labels(PlotRange range, double step) {
  std::vector<std::string> labels;
  for (const double tick : RoundTicks(range, step)) labels.push_back(TickLabel(tick, step));
  return labels;
}

TEST(PlotAxesTest, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(RoundStep(1.0, 10), 0.1);
  EXPECT_DOUBLE_EQ(RoundStep(1.0, 5), 0.2);
  EXPECT_DOUBLE_EQ(RoundStep(1.0, 4), 0.5);
  EXPECT_DOUBLE_EQ(RoundStep(1.0, 1), 1.0);
  EXPECT_DOUBLE_EQ(RoundStep(7.0, 10), 1.0);
  EXPECT_DOUBLE_EQ(RoundStep(250.0, 2), 200.0);
  EXPECT_DOUBLE_EQ(RoundStep(0.003, 3), 0.001);
}

TEST(PlotAxesTest, NoMoreStepsThanAskedFor) {
  for (double size = 1e-6; size < 1e6; size *= 1.37) {
    for (const int max_count : {1, 2, 3, 7, 20}) {
      const double step = RoundStep(size, max_count);
      EXPECT_LE(size / step, max_count * (1.0 + 1e-9)) << size << ", " << max_count;
      // The next finer step is 2 or 2.5 times smaller and would not do.
      EXPECT_GT(size / step, max_count / 2.5 * (1.0 - 1e-9)) << size << ", " << max_count;
    }
  }
}

TEST(PlotAxesTest, TicksAreTheMultiplesInRangeWithItsEnds) {
  EXPECT_EQ(Labels({-0.1, 0.35}, 0.1),
            (std::vector<std::string>{"-0.1", "0.0", "0.1", "0.2", "0.3"}));
  EXPECT_EQ(Labels({0.1, 0.3}, 0.1), (std::vector<std::string>{"0.1", "0.2", "0.3"}));
  EXPECT_EQ(Labels({-30.0, 25.0}, 20.0), (std::vector<std::string>{"-20", "0", "20"}));
  EXPECT_TRUE(Labels({0.1, 0.9}, 1.0).empty());
}

TEST(PlotAxesTest, LabelsHaveJustTheDecimalsThatTellTicksApart) {
  EXPECT_EQ(TickLabel(0.25, 0.05), "0.25");
  EXPECT_EQ(TickLabel(3.0, 0.5), "3.0");
  EXPECT_EQ(TickLabel(-3.0, 1.0), "-3");
  EXPECT_EQ(TickLabel(1500.0, 500.0), "1500");
  EXPECT_EQ(TickLabel(0.002, 0.001), "0.002");
  EXPECT_EQ(TickLabel(-0.0, 0.1), "0.0");
  EXPECT_EQ(TickLabel(-1e-17, 0.1), "0.0");
}

TEST(PlotAxesTest, PutsDataIntoItsAreaWithYUp) {
  PlotCanvas canvas({300, 200});
  const PlotAxes axes(canvas, {50.0, 20.0, 200.0, 100.0}, {-1.0, 1.0}, {0.0, 10.0});
  EXPECT_EQ(axes.ToCanvas({-1.0, 0.0}), cv::Point2d(50.0, 120.0));
  EXPECT_EQ(axes.ToCanvas({1.0, 10.0}), cv::Point2d(250.0, 20.0));
  EXPECT_EQ(axes.ToCanvas({0.0, 5.0}), cv::Point2d(150.0, 70.0));
}

TEST(PlotAxesTest, ALineOfOnePointIsADot) {
  PlotCanvas canvas({300, 200});
  PlotAxes axes(canvas, {50.0, 20.0, 200.0, 100.0}, {-1.0, 1.0}, {0.0, 10.0});
  const cv::Vec3b red(0, 0, 255);
  axes.DrawLine({{0.0, 5.0}}, cv::Scalar(red), 3.0);
  axes.DrawLine({}, cv::Scalar(red), 3.0);
  EXPECT_EQ(canvas.Image().at<cv::Vec3b>(70, 150), red);
}

}  // namespace
}  // namespace semantic_slam
