#include "semantic_slam/worlds/scenery.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

class SceneryTest : public ::testing::Test {
 protected:
  cv::Mat3b image_ = cv::Mat3b(240, 320, cv::Vec3b::all(0));
  Painter painter_{image_, 0.002, 3};
};

TEST_F(SceneryTest, EverySceneCoversTheWholePicture) {
  for (const auto paint :
       {PaintLandscape, PaintStreet, PaintPortrait, PaintStillLife, PaintAbstract, PaintScene}) {
    const cv::Vec3b unpainted(1, 2, 3);
    image_ = unpainted;
    paint(painter_, Bgr(200, 160, 120));
    cv::Mat1b left_out;
    cv::inRange(image_, unpainted, unpainted, left_out);
    EXPECT_EQ(cv::countNonZero(left_out), 0);
  }
}

TEST_F(SceneryTest, SkyIsAboveTheLand) {
  PaintLandscape(painter_, Bgr(220, 170, 110));
  const Bgr top = cv::mean(image_.rowRange(0, 20));
  const Bgr bottom = cv::mean(image_.rowRange(220, 240));
  EXPECT_GT(top[0], top[2]);        // blue
  EXPECT_GT(bottom[1], bottom[0]);  // green
}

TEST_F(SceneryTest, WordsAreAsManyAsAskedFor) {
  EXPECT_EQ(Words(painter_, 0), "");
  for (int i = 0; i < 20; ++i) {
    const std::string words = Words(painter_, 2);
    const std::size_t space = words.find(' ');
    ASSERT_NE(space, std::string::npos);
    EXPECT_NE(words.substr(0, space), words.substr(space + 1));
  }
}

TEST_F(SceneryTest, LetteringFits) {
  const double letter_m = LetterToFit(painter_, "A LONG TITLE", 0.4, 0.3);
  EXPECT_LT(letter_m, 0.3);
  // Widths are whole texels and lines at least one texel thick.
  EXPECT_NEAR(painter_.TextWidth(letter_m, "A LONG TITLE"), 0.4, 0.03);
  EXPECT_DOUBLE_EQ(LetterToFit(painter_, "I", 0.4, 0.05), 0.05);
}

}  // namespace
}  // namespace semantic_slam
