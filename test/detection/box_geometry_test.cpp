#include "semantic_slam/detection/box_geometry.h"

#include <limits>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(UnitOfTest, IsAPixelOrTheInput) {
  ModelCard card;
  card.input.width_px = 64;
  card.input.height_px = 48;
  card.head.units = BoxUnits::kPixels;
  EXPECT_EQ(UnitOf(card), cv::Size2f(1, 1));
  card.head.units = BoxUnits::kNormalised;
  EXPECT_EQ(UnitOf(card), cv::Size2f(64, 48));
}

TEST(BoxOfTest, CornersAndCentreSayTheSame) {
  const cv::Rect2f expected(2.0f, 10.0f, 4.0f, 30.0f);
  const float corners[] = {1.0f, 1.0f, 3.0f, 4.0f}, centre[] = {2.0f, 2.5f, 2.0f, 3.0f};
  EXPECT_EQ(BoxOfCorners(corners, {2.0f, 10.0f}), expected);
  EXPECT_EQ(BoxOfCentre(centre, {2.0f, 10.0f}), expected);
}

TEST(IsUsableTest, WantsAFiniteArea) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(IsUsable({-5, -5, 1, 1}));
  EXPECT_FALSE(IsUsable({0, 0, 0, 1}));
  EXPECT_FALSE(IsUsable({0, 0, 1, -1}));
  EXPECT_FALSE(IsUsable({nan, 0, 1, 1}));
  EXPECT_FALSE(IsUsable({0, -inf, 1, 1}));
  EXPECT_FALSE(IsUsable({0, 0, inf, 1}));
}

TEST(PartInImageTest, GoesFromCornersOfPixelsToTheirCentres) {
  const ImageFit fit({640, 480}, {640, 480}, FitMode::kStretch);
  EXPECT_EQ(PartInImage({0, 0, 640, 480}, fit, {640, 480}), cv::Rect2f(-0.5f, -0.5f, 640, 480));
  EXPECT_EQ(PartInImage({10, 20, 30, 40}, fit, {640, 480}), cv::Rect2f(9.5f, 19.5f, 30, 40));
}

TEST(PartInImageTest, UndoesTheLetterbox) {
  // 1280 x 720 in 640 x 640: half the size, 140 px below the upper edge.
  const ImageFit fit({1280, 720}, {640, 640}, FitMode::kLetterbox);
  EXPECT_EQ(PartInImage({10, 150, 20, 30}, fit, {1280, 720}), cv::Rect2f(19.5f, 19.5f, 40, 60));
}

TEST(PartInImageTest, CutsAndDropsWhatIsOffTheImage) {
  const ImageFit fit({640, 320}, {640, 480}, FitMode::kLetterbox);  // 80 px of padding above
  EXPECT_EQ(PartInImage({-10, 60, 30, 40}, fit, {640, 320}), cv::Rect2f(-0.5f, -0.5f, 20, 20));
  EXPECT_FALSE(PartInImage({100, 20, 50, 60}, fit, {640, 320})) << "all in the padding";
  EXPECT_FALSE(PartInImage({700, 100, 50, 60}, fit, {640, 320})) << "to the right of it";
}

TEST(IntersectionOverUnionTest, KnownBoxes) {
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({0, 0, 2, 2}, {0, 0, 2, 2}), 1.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({0, 0, 2, 2}, {1, 0, 2, 2}), 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({0, 0, 2, 2}, {2, 0, 2, 2}), 0.0);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({0, 0, 4, 4}, {1, 1, 2, 2}), 0.25);
  EXPECT_DOUBLE_EQ(IntersectionOverUnion({0, 0, 0, 0}, {0, 0, 0, 0}), 0.0);
}

}  // namespace
}  // namespace semantic_slam
