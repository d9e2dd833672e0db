#include "semantic_slam/object_tracking/camera_motion.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// Smooth random texture, so that flow has something to follow at every scale.
cv::Mat Texture() {
  cv::Mat image(60, 80, CV_8UC3);
  cv::RNG(1).fill(image, cv::RNG::UNIFORM, 0, 255);
  cv::resize(image, image, {640, 480}, 0, 0, cv::INTER_CUBIC);
  return image;
}

cv::Mat Warped(const cv::Mat& image, const ImageMotion& motion) {
  const cv::Matx23d affine(motion(0, 0), motion(0, 1), motion(0, 2), motion(1, 0), motion(1, 1),
                           motion(1, 2));
  cv::Mat warped;
  cv::warpAffine(image, warped, affine, image.size(), cv::INTER_LINEAR, cv::BORDER_REFLECT);
  return warped;
}

// Where the motion takes the corners of the image differs by at most `px`.
void ExpectSameMotion(const ImageMotion& a, const ImageMotion& b, double px) {
  for (const double x : {0.0, 640.0}) {
    for (const double y : {0.0, 480.0}) {
      const Eigen::Vector3d corner(x, y, 1.0);
      EXPECT_LT((a * corner - b * corner).norm(), px);
    }
  }
}

ImageMotion Motion(double angle_rad, double zoom, double x, double y) {
  ImageMotion motion;
  motion << zoom * std::cos(angle_rad), -zoom * std::sin(angle_rad), x, zoom * std::sin(angle_rad),
      zoom * std::cos(angle_rad), y;
  return motion;
}

TEST(CameraMotionTest, FindsShiftTurnAndZoom) {
  const cv::Mat image = Texture();
  for (const ImageMotion& truth : {Motion(0, 1, 24, -10), Motion(0.05, 1.0, 3, 5),
                                   Motion(-0.03, 1.05, -20, 8), Motion(0, 1, 0, 0)}) {
    CameraMotion motion;
    motion.Update(image);
    // Half a pixel of the half-size image over its whole width.
    ExpectSameMotion(motion.Update(Warped(image, truth)), truth, 1.0);
  }
}

TEST(CameraMotionTest, WhatMovesByItselfDoesNotCount) {
  const cv::Mat image = Texture();
  const ImageMotion truth = Motion(0, 1, 10, 0);
  cv::Mat next = Warped(image, truth);
  image(cv::Rect(100, 100, 200, 250)).copyTo(next(cv::Rect(85, 130, 200, 250)));
  CameraMotion motion;
  motion.Update(image);
  ExpectSameMotion(motion.Update(next), truth, 1.0);
}

TEST(CameraMotionTest, GreyAndColourImagesDoAlike) {
  const cv::Mat image = Texture();
  const ImageMotion truth = Motion(0, 1, 12, 6);
  cv::Mat grey, next_grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(Warped(image, truth), next_grey, cv::COLOR_BGR2GRAY);
  CameraMotion motion;
  motion.Update(grey);
  ExpectSameMotion(motion.Update(next_grey), truth, 1.0);
}

TEST(CameraMotionTest, WhereNothingCanBeToldThereIsNoMotion) {
  const ImageMotion none = ImageMotion::Identity();
  CameraMotion motion;
  EXPECT_EQ(motion.Update(Texture()), none);                            // the first
  EXPECT_EQ(motion.Update(Texture()(cv::Rect(0, 0, 320, 240))), none);  // another size
  EXPECT_EQ(motion.Update(cv::Mat()), none);
  EXPECT_EQ(motion.Update(Texture()), none);  // the first after an empty one
  EXPECT_EQ(motion.Update(BlankImage(Stamp{1}).colour), none);
  EXPECT_EQ(motion.Update(cv::Mat(480, 640, CV_8UC1, cv::Scalar(0))), none);
  EXPECT_EQ(motion.Update(cv::Mat(480, 640, CV_8UC1, cv::Scalar(0))), none);
  EXPECT_EQ(motion.Update(cv::Mat(1, 1, CV_8UC1, cv::Scalar(0))), none);
}

TEST(CameraMotionTest, TheSameImagesGiveTheSameBytes) {
  const cv::Mat image = Texture(), next = Warped(image, Motion(0.02, 1.01, 7, -9));
  CameraMotion a, b;
  a.Update(image), b.Update(image);
  EXPECT_EQ(a.Update(next), b.Update(next));
}

}  // namespace
}  // namespace semantic_slam
