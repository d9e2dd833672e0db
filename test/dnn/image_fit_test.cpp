#include "semantic_slam/dnn/image_fit.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

void ExpectNear(const cv::Point2f& actual, const cv::Point2f& expected) {
  EXPECT_NEAR(actual.x, expected.x, 1e-4);  // [px]: single precision at some hundred pixels
  EXPECT_NEAR(actual.y, expected.y, 1e-4);
}

TEST(ImageFitTest, LetterboxKeepsTheShapeAndCentres) {
  const ImageFit wide({1280, 720}, {640, 640}, FitMode::kLetterbox);
  EXPECT_EQ(wide.content(), cv::Rect(0, 140, 640, 360));
  const ImageFit tall({100, 400}, {64, 48}, FitMode::kLetterbox);
  EXPECT_EQ(tall.content(), cv::Rect(26, 0, 12, 48));
}

TEST(ImageFitTest, StretchUsesAllOfTheInput) {
  const ImageFit fit({1280, 720}, {320, 240}, FitMode::kStretch);
  EXPECT_EQ(fit.content(), cv::Rect(0, 0, 320, 240));
  EXPECT_FLOAT_EQ(fit.scale_x(), 4.0f);
  EXPECT_FLOAT_EQ(fit.scale_y(), 3.0f);
}

TEST(ImageFitTest, AnImageOfTheInputsSizeStaysWhereItIs) {
  for (const FitMode mode : {FitMode::kLetterbox, FitMode::kStretch}) {
    const ImageFit fit({640, 480}, {640, 480}, mode);
    ExpectNear(fit.ToImage({12.0f, 34.5f}), {12.0f, 34.5f});
  }
}

TEST(ImageFitTest, EdgesGoToEdges) {
  // Edges of pixels lie half a pixel before their centres.
  const ImageFit fit({1280, 720}, {640, 640}, FitMode::kLetterbox);
  ExpectNear(fit.ToImage({-0.5f, 139.5f}), {-0.5f, -0.5f});
  ExpectNear(fit.ToImage({639.5f, 499.5f}), {1279.5f, 719.5f});
  // The first input pixel shows the first two of the image: its centre lies between theirs.
  ExpectNear(fit.ToImage({0.0f, 140.0f}), {0.5f, 0.5f});
}

TEST(ImageFitTest, AnImageOfOnePixelFits) {
  const ImageFit fit({1, 5000}, {64, 48}, FitMode::kLetterbox);
  EXPECT_EQ(fit.content().width, 1);
  EXPECT_EQ(fit.content().height, 48);
}

}  // namespace
}  // namespace semantic_slam
