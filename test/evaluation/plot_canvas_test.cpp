#include "semantic_slam/evaluation/plot_canvas.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

const cv::Vec3b kWhite(255, 255, 255);
const cv::Vec3b kRed(0, 0, 255);
const cv::Scalar kRedInk(0, 0, 255);

// The smallest box around everything that is not white.
cv::Rect InkBox(const cv::Mat& image) {
  cv::Mat ink;
  cv::inRange(image, cv::Scalar::all(255), cv::Scalar::all(255), ink);
  std::vector<cv::Point> points;
  cv::findNonZero(~ink, points);
  if (points.empty()) return {};
  cv::Point low = points[0];
  cv::Point high = points[0];
  for (const cv::Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return {low, high + cv::Point(1, 1)};
}

TEST(PlotCanvasTest, StartsWhiteAndOfTheGivenSize) {
  const cv::Mat image = PlotCanvas({30, 20}).Image();
  EXPECT_EQ(image.size(), cv::Size(30, 20));
  EXPECT_EQ(image.type(), CV_8UC3);
  EXPECT_TRUE(InkBox(image).empty());
}

TEST(PlotCanvasTest, DrawsWhereItIsTold) {
  PlotCanvas canvas({40, 30});
  canvas.Line({5.0, 10.0}, {35.0, 10.0}, kRedInk, 4.0);
  const cv::Mat image = canvas.Image();
  EXPECT_EQ(image.at<cv::Vec3b>(9, 20), kRed);  // rows 8 to 11 are within 2 of y = 10
  EXPECT_EQ(image.at<cv::Vec3b>(10, 20), kRed);
  EXPECT_EQ(image.at<cv::Vec3b>(6, 20), kWhite);
  EXPECT_EQ(image.at<cv::Vec3b>(13, 20), kWhite);
  EXPECT_EQ(image.at<cv::Vec3b>(10, 1), kWhite);
  EXPECT_EQ(image.at<cv::Vec3b>(10, 38), kWhite);
}

TEST(PlotCanvasTest, ADashedLineHasGaps) {
  PlotCanvas canvas({100, 20});
  canvas.DashedLine({0.0, 10.0}, {100.0, 10.0}, kRedInk, 2.0);
  const cv::Mat row = canvas.Image().row(10);
  int changes = 0;
  for (int x = 1; x < row.cols; ++x) {
    changes += (row.at<cv::Vec3b>(x) == kWhite) != (row.at<cv::Vec3b>(x - 1) == kWhite);
  }
  EXPECT_GE(changes, 10);  // ends of dashes
}

TEST(PlotCanvasTest, MarkersStandOutFromWhatLiesBeneath) {
  PlotCanvas canvas({100, 40});
  canvas.Line({0.0, 20.0}, {100.0, 20.0}, cv::Scalar::all(0), 30.0);
  canvas.Dot({25.0, 20.0}, 5.0, kRedInk);
  canvas.Square({75.0, 20.0}, 5.0, kRedInk);
  const cv::Mat image = canvas.Image();
  for (const int x : {25, 75}) {
    EXPECT_EQ(image.at<cv::Vec3b>(20, x), kRed);
    EXPECT_GT(image.at<cv::Vec3b>(20, x + 5)[0], 128);  // the white rim
    EXPECT_EQ(image.at<cv::Vec3b>(20, x + 9), cv::Vec3b(0, 0, 0));
  }
}

TEST(PlotCanvasTest, AlignsTextToItsAnchor) {
  const auto ink = [](HorizontalAlign align) {
    PlotCanvas canvas({200, 50});
    canvas.Text("HHH", {100.0, 30.0}, align, 14.0, cv::Scalar::all(0));
    return InkBox(canvas.Image());
  };
  // The letters' own margins are a few pixels.
  EXPECT_NEAR(ink(HorizontalAlign::kLeft).x, 100, 4);
  EXPECT_NEAR(ink(HorizontalAlign::kRight).br().x, 100, 4);
  const cv::Rect centred = ink(HorizontalAlign::kCentre);
  EXPECT_NEAR(centred.x + 0.5 * centred.width, 100.0, 2.0);
  EXPECT_NEAR(centred.br().y, 30, 2);  // stands on the base line
  EXPECT_NEAR(centred.height, 14, 3);  // as high as asked for, and the stroke
  EXPECT_NEAR(centred.width, PlotCanvas::TextWidth("HHH", 14.0), 5.0);
}

TEST(PlotCanvasTest, WritesUpwardsAroundACentre) {
  PlotCanvas canvas({100, 200});
  canvas.VerticalText("HHHHH", {50.0, 100.0}, 14.0, cv::Scalar::all(0));
  const cv::Rect ink = InkBox(canvas.Image());
  EXPECT_GT(ink.height, 3 * ink.width);
  EXPECT_NEAR(ink.x + 0.5 * ink.width, 50.0, 3.0);
  EXPECT_NEAR(ink.y + 0.5 * ink.height, 100.0, 3.0);
}

TEST(PlotCanvasTest, DropsWhatLiesOutside) {
  PlotCanvas canvas({20, 20});
  canvas.Line({-50.0, -10.0}, {70.0, -10.0}, kRedInk, 2.0);
  canvas.Dot({100.0, 100.0}, 5.0, kRedInk);
  canvas.Text("text", {30.0, 60.0}, HorizontalAlign::kLeft, 14.0, kRedInk);
  canvas.VerticalText("far away", {-500.0, 10.0}, 14.0, kRedInk);
  EXPECT_TRUE(InkBox(canvas.Image()).empty());
  canvas.VerticalText("longer than the page is high", {10.0, 10.0}, 14.0, kRedInk);
  EXPECT_FALSE(InkBox(canvas.Image()).empty());
}

TEST(PlotCanvasTest, PastesAPictureAsItIs) {
  PlotCanvas canvas({20, 10});
  cv::Mat picture(2, 3, CV_8UC3, cv::Scalar(kRedInk));
  picture.at<cv::Vec3b>(1, 2) = {1, 2, 3};
  canvas.Paste(picture, {5, 4});
  const cv::Mat image = canvas.Image();
  EXPECT_EQ(InkBox(image), cv::Rect(5, 4, 3, 2));
  EXPECT_EQ(image.at<cv::Vec3b>(4, 5), kRed);
  EXPECT_EQ(image.at<cv::Vec3b>(5, 7), cv::Vec3b(1, 2, 3));
}

TEST(PlotCanvasTest, ARimSetsTextOffFromAPicture) {
  PlotCanvas plain({60, 30}), rimmed({60, 30});
  const cv::Mat red(30, 60, CV_8UC3, cv::Scalar(kRedInk));
  for (PlotCanvas* canvas : {&plain, &rimmed}) canvas->Paste(red, {0, 0});
  plain.Text("x", {30.0, 20.0}, HorizontalAlign::kCentre, 10.0, {0, 0, 0});
  rimmed.RimmedText("x", {30.0, 20.0}, HorizontalAlign::kCentre, 10.0, {0, 0, 0});
  const auto count_white = [](const cv::Mat& image) {
    cv::Mat white;
    cv::inRange(image, cv::Scalar::all(250), cv::Scalar::all(255), white);
    return cv::countNonZero(white);
  };
  EXPECT_EQ(count_white(plain.Image()), 0);
  EXPECT_GT(count_white(rimmed.Image()), 10);
}

}  // namespace
}  // namespace semantic_slam
