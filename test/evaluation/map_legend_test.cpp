#include "semantic_slam/evaluation/map_legend.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const cv::Scalar kRed(0, 0, 255);
const cv::Scalar kBlue(255, 0, 0);

int CountOf(const cv::Mat& image, const cv::Scalar& colour, const cv::Rect& part) {
  cv::Mat mask;
  cv::inRange(image(part), colour, colour, mask);
  return cv::countNonZero(mask);
}

TEST(MapLegendTest, ListsEntriesBelowEachOther) {
  PlotCanvas canvas({100, 60});
  DrawLegend({{"a", kRed}, {"b", kBlue}}, {0.0, 0.0}, 60.0, canvas);
  const cv::Mat image = canvas.Image();
  EXPECT_GT(CountOf(image, kRed, {0, 0, 20, 26}), 100);
  EXPECT_GT(CountOf(image, kBlue, {0, 26, 20, 26}), 100);
}

TEST(MapLegendTest, LeavesOutWhatDoesNotFit) {
  PlotCanvas canvas({100, 60});
  DrawLegend({{"a", kRed}, {"b", kBlue}}, {0.0, 0.0}, 30.0, canvas);
  EXPECT_EQ(CountOf(canvas.Image(), kBlue, {0, 0, 100, 60}), 0);
}

// Where the bar ends: the last column that is dark at the height of the bar.
int BarEnd(double pixels_per_metre, double room_px) {
  PlotCanvas canvas({400, 40});
  DrawScaleBar(pixels_per_metre, room_px, {10.0, 20.0}, canvas);
  const cv::Mat image = canvas.Image();
  int end = 0;
  for (int x = 10; x < image.cols && image.at<cv::Vec3b>(20, x)[0] < 100; ++x) end = x;
  return end;
}

TEST(MapLegendTest, ABarIsOfARoundLength) {
  // Of 1, 2, 5 m the longest that fits: 1 m of 1.5, 2 m of 3, 5 m of 5.5.
  EXPECT_NEAR(BarEnd(100.0, 150.0), 110, 2);
  EXPECT_NEAR(BarEnd(100.0, 300.0), 210, 2);
  EXPECT_NEAR(BarEnd(20.0, 110.0), 110, 2);
}

}  // namespace
}  // namespace semantic_slam
