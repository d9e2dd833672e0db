#include "semantic_slam/worlds/painter.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

constexpr double kTexelM = 0.01;

const Bgr kRed(0, 0, 255);

cv::Mat3b Black(int columns, int rows) {
  return cv::Mat3b(rows, columns, cv::Vec3b::all(0));
}
bool IsRed(const cv::Mat3b& image, int x, int y) {
  return image(y, x) == cv::Vec3b(0, 0, 255);
}

TEST(ColourTest, HsvGivesTheColoursOfTheRainbow) {
  EXPECT_EQ(Hsv(0, 1, 1), Bgr(0, 0, 255));
  EXPECT_EQ(Hsv(1.0 / 3, 1, 1), Bgr(0, 255, 0));
  EXPECT_EQ(Hsv(2.0 / 3, 1, 1), Bgr(255, 0, 0));
  EXPECT_EQ(Hsv(1.0 / 6, 1, 1), Bgr(0, 255, 255));
  EXPECT_EQ(Hsv(0.4, 0, 0.5), Bgr(127.5, 127.5, 127.5));
  EXPECT_EQ(Hsv(-1, 1, 1), Hsv(0, 1, 1));
}

TEST(ColourTest, InkCanBeReadOnItsPaper) {
  EXPECT_LT(Luma(InkOn(Bgr::all(255))), 50);
  EXPECT_GT(Luma(InkOn(Bgr::all(0))), 200);
}

TEST(PainterTest, RectangleIsWhereItsMetresSay) {
  cv::Mat3b image = Black(20, 10);
  Painter(image, kTexelM, 1).Rectangle(0.02, 0.03, 0.05, 0.04, kRed);
  EXPECT_EQ(cv::sum(image)[2], 5 * 4 * 255);
  EXPECT_TRUE(IsRed(image, 2, 3));
  EXPECT_TRUE(IsRed(image, 6, 6));
}

TEST(PainterTest, CutsOffWhatIsOutside) {
  cv::Mat3b image = Black(16, 16);
  Painter painter(image, kTexelM, 1);
  painter.Rectangle(-0.05, -0.05, 0.06, 0.06, kRed);
  painter.Rectangle(0.5, 0.5, 1, 1, kRed);
  painter.Disc({-1, -1}, 0.1, kRed);
  EXPECT_EQ(cv::sum(image)[2], 255);
}

TEST(PainterTest, WhatLeavesAnImageThatWrapsComesInOpposite) {
  cv::Mat3b image = Black(16, 16);
  Painter painter(image, kTexelM, 1, true);
  painter.Rectangle(0.15, 0.15, 0.02, 0.02, kRed);
  EXPECT_EQ(cv::sum(image)[2], 4 * 255);
  for (const int x : {0, 15}) {
    for (const int y : {0, 15}) EXPECT_TRUE(IsRed(image, x, y)) << x << " " << y;
  }
}

TEST(PainterTest, DiscHasTheAreaOfACircle) {
  cv::Mat3b image = Black(64, 64);
  Painter(image, kTexelM, 1).Disc({0.32, 0.32}, 0.2, kRed);
  // Anti-aliasing spreads the rim over up to a texel.
  EXPECT_NEAR(cv::sum(image)[2] / 255, CV_PI * 20.5 * 20.5, 2 * CV_PI * 20.5 / 2);
  EXPECT_TRUE(IsRed(image, 32, 32));
}

TEST(PainterTest, PartDrawsWithinItsRectangleOnly) {
  cv::Mat3b image = Black(20, 20);
  Painter painter(image, kTexelM, 1);
  Painter part = painter.Part(0.05, 0.1, 0.04, 0.3);  // reaches 0.2 m too far down
  EXPECT_EQ(part.size_px(), cv::Size(4, 10));
  part.Fill(kRed);
  EXPECT_EQ(cv::sum(image)[2], 40 * 255);
  EXPECT_TRUE(IsRed(image, 5, 10));
}

TEST(PainterTest, PartOutsideIsNotEmpty) {
  cv::Mat3b image = Black(20, 20);
  Painter painter(image, kTexelM, 1);
  EXPECT_EQ(painter.Part(3, 3, 1, 1).size_px(), cv::Size(1, 1));
  EXPECT_EQ(painter.Part(-3, 0, 1, -1).size_px(), cv::Size(1, 1));
}

TEST(PainterTest, NoiseIsCentredAndSmooth) {
  cv::Mat3b image = Black(256, 256);
  for (const bool wraps : {false, true}) {
    const cv::Mat1f noise = Painter(image, kTexelM, 5, wraps).Noise(0.16);
    ASSERT_EQ(noise.size(), image.size());
    // 256 cells, each uniform in -1..1: their mean's deviation is 0.58 / 16.
    EXPECT_NEAR(cv::mean(noise)[0], 0.0, 4 * 0.58 / 16);
    // Between two values 16 texels apart, at most 2 different, cubic slopes reach 1.5 times 2/16.
    const cv::Mat1f step = noise.colRange(1, 256) - noise.colRange(0, 255);
    EXPECT_LT(cv::norm(step, cv::NORM_INF), 0.2);
  }
}

TEST(PainterTest, NoiseThatWrapsMeetsItself) {
  cv::Mat3b image = Black(128, 128);
  const cv::Mat1f noise = Painter(image, kTexelM, 5, true).Noise(0.3, 0.1);
  EXPECT_LT(cv::norm(noise.col(0), noise.col(127), cv::NORM_INF), 0.2);
  EXPECT_LT(cv::norm(noise.row(0), noise.row(127), cv::NORM_INF), 0.5);
}

TEST(PainterTest, GlazeMixesByItsShare) {
  cv::Mat3b image = Black(2, 1);
  cv::Mat1f share(1, 2);
  share << 0.0f, 0.5f;
  Painter(image, kTexelM, 1).Glaze(Bgr(200, 100, 50), share);
  EXPECT_EQ(image(0, 0), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(image(0, 1), cv::Vec3b(100, 50, 25));
}

TEST(PainterTest, GreySaturates) {
  cv::Mat3b image(1, 1, cv::Vec3b(10, 100, 250));
  Painter(image, kTexelM, 1).AddGrey(cv::Mat1f(1, 1, 20.0f));
  EXPECT_EQ(image(0, 0), cv::Vec3b(30, 120, 255));
}

TEST(PainterTest, SetsTheMean) {
  cv::Mat3b image = Black(32, 32);
  Painter painter(image, kTexelM, 1);
  painter.Fill(Bgr::all(90));
  painter.AddNoise(0.05, 20);
  painter.SetMean(Bgr(100, 110, 120));
  const Bgr mean = cv::mean(image);
  // Every texel is moved by the same whole number.
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(mean[i], 100 + 10 * i, 0.5) << i;
}

TEST(PainterTest, TurnedTextRunsDownwards) {
  cv::Mat3b image = Black(64, 128);
  Painter painter(image, kTexelM, 1);
  painter.Text(0.1, 0.1, 0.12, "TURNED", kRed, true);
  cv::Mat1b red;
  cv::extractChannel(image, red, 2);
  const cv::Rect inked = cv::boundingRect(red);
  EXPECT_GT(inked.height, 2 * inked.width);
  // Letters may leave a texel of space around them, and lines are 1 to 2 texels thick.
  EXPECT_NEAR(inked.x, 10, 3);
  EXPECT_NEAR(inked.y, 10, 3);
  EXPECT_NEAR(inked.height * kTexelM, painter.TextWidth(0.12, "TURNED"), 0.04);
}

TEST(PainterTest, PrintStaysInItsRectangle) {
  for (const double line_m : {0.03, 0.2}) {  // bars, letters
    cv::Mat3b image = Black(200, 200);
    Painter(image, kTexelM, 1).Print(0.5, 0.5, 1.0, 1.0, line_m, Bgr::all(255));
    EXPECT_GT(cv::sum(image)[0], 0.0) << line_m;
    cv::Mat grey;
    cv::extractChannel(image, grey, 0);
    const cv::Rect inked = cv::boundingRect(grey);
    EXPECT_EQ(inked & cv::Rect(48, 48, 104, 104), inked) << line_m;  // 2 texels of descenders
  }
}

TEST(PainterTest, SameSeedDrawsTheSame) {
  const auto draw = [](std::uint64_t seed) {
    cv::Mat3b image = Black(64, 64);
    Painter painter(image, kTexelM, seed, true);
    painter.Flecks(300, 0.02, 0.05, Bgr::all(120), 60);
    painter.AddNoise(0.02, 10);
    return image;
  };
  EXPECT_EQ(cv::norm(draw(1), draw(1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(draw(1), draw(2), cv::NORM_INF), 0.0);
}

TEST(PainterTest, IntegersIncludeBothEnds) {
  cv::Mat3b image = Black(1, 1);
  Painter painter(image, kTexelM, 1);
  bool seen[3] = {};
  for (int i = 0; i < 100; ++i) {
    const int value = painter.Integer(4, 6);
    ASSERT_TRUE(value >= 4 && value <= 6) << value;
    seen[value - 4] = true;
  }
  EXPECT_TRUE(seen[0] && seen[1] && seen[2]);
}

}  // namespace
}  // namespace semantic_slam
