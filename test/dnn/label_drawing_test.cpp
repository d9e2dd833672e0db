#include "semantic_slam/dnn/label_drawing.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(ColourOfTest, FollowsTheChannelOrder) {
  LabelClass label;
  label.rgb = {1, 2, 3};
  EXPECT_EQ(ColourOf(label, ColourOrder::kRgb), cv::Scalar(1, 2, 3));
  EXPECT_EQ(ColourOf(label, ColourOrder::kBgr), cv::Scalar(3, 2, 1));
}

// The brightest and the darkest of a tag's grey levels.
std::pair<double, double> RangeOf(const cv::Scalar& colour) {
  cv::Mat picture(40, 200, CV_8UC3, cv::Scalar::all(77));
  const cv::Rect tag(10, 5, TagWidthPx("chair"), kTagHeightPx);
  DrawTag(picture, tag.tl(), "chair", colour);
  EXPECT_EQ(picture.at<cv::Vec3b>(tag.y - 1, tag.x), cv::Vec3b::all(77));
  EXPECT_EQ(picture.at<cv::Vec3b>(tag.y, tag.x), cv::Vec3b(colour[0], colour[1], colour[2]));
  EXPECT_EQ(picture.at<cv::Vec3b>(tag.y, tag.br().x), cv::Vec3b::all(77));
  double least = 0.0, greatest = 0.0;
  cv::minMaxLoc(picture(tag).clone().reshape(1), &least, &greatest);
  return {least, greatest};
}

TEST(DrawTagTest, WritesSoThatItCanBeRead) {
  EXPECT_GT(RangeOf(cv::Scalar::all(40)).second, 200.0) << "white on dark";
  EXPECT_LT(RangeOf(cv::Scalar::all(220)).first, 60.0) << "black on bright";
}

TEST(DrawTagTest, CutsWhatLiesOffThePicture) {
  cv::Mat picture(10, 10, CV_8UC3, cv::Scalar::all(0));
  DrawTag(picture, {-5, -5}, "chair", cv::Scalar::all(90));
  DrawTag(picture, {100, 100}, "chair", cv::Scalar::all(90));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0), cv::Vec3b::all(90));
}

}  // namespace
}  // namespace semantic_slam
