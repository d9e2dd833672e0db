#include "semantic_slam_ros/feature_drawing.h"

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::ColourOrder;
using semantic_slam::FeatureView;

ColourImage Black(ColourOrder order) {
  return {cv::Mat(100, 200, CV_8UC3, cv::Scalar(0, 0, 0)), order};
}

semantic_slam::TrackedImage Tracked() {
  semantic_slam::TrackedImage image;
  image.status = semantic_slam::TrackingStatus::kTracking;
  return image;
}

TEST(FeatureDrawingTest, InliersAreGreenInBothColourOrdersAndOthersGrey) {
  const std::vector<FeatureView> features{{{50.0f, 40.0f}, 31.0f, true, false},
                                          {{150.0f, 40.0f}, 31.0f, false, false}};
  for (const ColourOrder order : {ColourOrder::kBgr, ColourOrder::kRgb}) {
    const ColourImage drawing = DrawFeatures(Black(order), features, Tracked());
    const auto inlier = drawing.pixels.at<cv::Vec3b>(40, 50);
    const auto other = drawing.pixels.at<cv::Vec3b>(40, 150);
    EXPECT_GT(inlier[1], 2 * inlier[0]);
    EXPECT_GT(inlier[1], 2 * inlier[2]);
    EXPECT_EQ(other[0], other[1]);
    EXPECT_GT(other[0], 0);
  }
}

TEST(FeatureDrawingTest, WhatMovesIsCrossedOutInOrangeInBothColourOrders) {
  const std::vector<FeatureView> features{{{50.0f, 40.0f}, 31.0f, false, true}};
  for (const ColourOrder order : {ColourOrder::kBgr, ColourOrder::kRgb}) {
    const ColourImage drawing = DrawFeatures(Black(order), features, Tracked());
    const auto centre = drawing.pixels.at<cv::Vec3b>(40, 50);
    const int red = order == ColourOrder::kRgb ? centre[0] : centre[2];
    const int blue = order == ColourOrder::kRgb ? centre[2] : centre[0];
    EXPECT_GT(red, centre[1]);
    EXPECT_GT(centre[1], 2 * blue);
  }
}

TEST(FeatureDrawingTest, LeavesTheImageItselfAlone) {
  const ColourImage image = Black(ColourOrder::kRgb);
  DrawFeatures(image, {{{50.0f, 40.0f}, 31.0f, true, false}}, Tracked());
  EXPECT_EQ(cv::countNonZero(image.pixels.reshape(1)), 0);
}

TEST(FeatureDrawingTest, SaysBelowHowTrackingGoes) {
  const ColourImage drawing = DrawFeatures(Black(ColourOrder::kRgb), {}, Tracked());
  EXPECT_EQ(drawing.pixels.cols, 200);
  ASSERT_GT(drawing.pixels.rows, 100);
  double brightest = 0.0;
  cv::minMaxLoc(drawing.pixels.rowRange(100, drawing.pixels.rows).clone().reshape(1), nullptr, &brightest);
  EXPECT_GT(brightest, 150.0) << "no text";
}

}  // namespace
}  // namespace semantic_slam_ros
