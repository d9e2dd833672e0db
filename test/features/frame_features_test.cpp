#include "semantic_slam/features/frame_features.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

CameraModel DistortedCamera() {
  CameraIntrinsics intrinsics = SmallIntrinsics();
  intrinsics.distortion = {0.25, -0.9, -0.005, 0.003, 1.1};
  return CameraModel(intrinsics);
}

std::vector<int> Near(const FrameFeatures& frame, const Eigen::Vector2f& pixel, float radius_px,
                      int min_octave, int max_octave) {
  std::vector<int> found;
  frame.ForEachNear(pixel, radius_px, min_octave, max_octave, [&](int i) { found.push_back(i); });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> NearByLookingAtAll(const FrameFeatures& frame, const Eigen::Vector2f& pixel,
                                    float radius_px, int min_octave, int max_octave) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(frame.size()); ++i) {
    const Feature& feature = frame[i];
    if (feature.octave < min_octave || feature.octave > max_octave) continue;
    if (std::abs(feature.pixel.x() - pixel.x()) > radius_px) continue;
    if (std::abs(feature.pixel.y() - pixel.y()) > radius_px) continue;
    found.push_back(i);
  }
  return found;
}

TEST(FrameFeaturesTest, PixelsAreUndistortedAndDepthIsThatOfTheRawPixel) {
  RgbdImage image = SquaresImage(1);
  for (int v = 0; v < image.depth_m.rows; ++v) {  // every pixel has a depth of its own
    for (int u = 0; u < image.depth_m.cols; ++u) {
      image.depth_m.at<float>(v, u) = 1.0f + 0.001f * static_cast<float>(v * 320 + u);
    }
  }
  const CameraModel camera = DistortedCamera();
  const FrameFeatures frame(image, camera, SmallExtractor());
  EXPECT_EQ(frame.stamp(), image.stamp);
  ASSERT_GT(frame.size(), 300u);
  ASSERT_EQ(frame.descriptors().size(), frame.size());
  for (const Feature& feature : frame.features()) {
    EXPECT_EQ(feature.pixel, camera.Undistort(feature.raw));
    EXPECT_TRUE(feature.has_depth());
    const cv::Point raw(cvRound(feature.raw.x()), cvRound(feature.raw.y()));
    EXPECT_EQ(feature.depth_m, image.depth_m.at<float>(raw));
  }
}

TEST(FrameFeaturesTest, WhatIsNoDistanceIsNoDepth) {
  for (const float none : {kNan, 0.0f, -1.0f, kInfinity, -kInfinity}) {
    RgbdImage image = SquaresImage(1);
    image.depth_m(cv::Rect(0, 0, 160, 240)).setTo(none);
    const FrameFeatures frame(image, *SmallCamera(), SmallExtractor());
    int without = 0;
    for (const Feature& feature : frame.features()) {
      const bool is_right = cvRound(feature.raw.x()) >= 160;
      EXPECT_EQ(feature.has_depth(), is_right) << none;
      EXPECT_EQ(std::isnan(feature.depth_m), !is_right) << none;
      without += !is_right;
    }
    EXPECT_GT(without, 100);
  }
}

TEST(FrameFeaturesTest, TheOrderOfColoursIsRespected) {
  RgbdImage image = SmallRoomImage(Rigid3d::Identity(), Stamp{1});
  const FrameFeatures bgr(image, *SmallCamera(), SmallExtractor());
  cv::cvtColor(image.colour, image.colour, cv::COLOR_BGR2RGB);
  image.order = ColourOrder::kRgb;
  const FrameFeatures rgb(image, *SmallCamera(), SmallExtractor());
  EXPECT_EQ(bgr.descriptors(), rgb.descriptors());
}

TEST(FrameFeaturesTest, ForEachNearFindsWhatASearchThroughAllFinds) {
  const FrameFeatures frame(SquaresImage(1), DistortedCamera(), SmallExtractor());
  std::mt19937 random(1);
  // Also about places outside of the image, where a search begins when a prediction is bad.
  std::uniform_real_distribution<float> u_px(-60.0f, 380.0f), v_px(-60.0f, 300.0f);
  std::uniform_real_distribution<float> radius_px(0.0f, 50.0f);
  std::uniform_int_distribution<int> octave(0, 7);
  std::size_t found = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2f pixel(u_px(random), v_px(random));
    const float radius = radius_px(random);
    const int min_octave = octave(random), max_octave = octave(random);
    const auto near = Near(frame, pixel, radius, min_octave, max_octave);
    EXPECT_EQ(near, NearByLookingAtAll(frame, pixel, radius, min_octave, max_octave))
        << pixel.transpose() << " +- " << radius;
    found += near.size();
  }
  EXPECT_GT(found, 500u);
}

TEST(FrameFeaturesTest, ForEachNearOfEverythingIsEverything) {
  const FrameFeatures frame(SquaresImage(1), DistortedCamera(), SmallExtractor());
  EXPECT_EQ(Near(frame, {160.0f, 120.0f}, 1000.0f, 0, 7).size(), frame.size());
}

TEST(FrameFeaturesTest, AnImageWithoutCornersIsNotAnError) {
  const FrameFeatures frame(BlankImage(Stamp{5}), *SmallCamera(), SmallExtractor());
  EXPECT_EQ(frame.size(), 0u);
  EXPECT_TRUE(Near(frame, {160.0f, 120.0f}, 1000.0f, 0, 7).empty());
}

TEST(FrameFeaturesTest, RefusesAnImageOfAnotherSizeAndSaysBothSizes) {
  RgbdImage image;
  image.colour = cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(0));
  image.depth_m = cv::Mat(120, 160, CV_32FC1, cv::Scalar::all(1));
  EXPECT_EQ(MessageOf<InputError>([&] { FrameFeatures(image, *SmallCamera(), SmallExtractor()); }),
            "image is [160 x 120] but the camera's calibration is for [320 x 240]");
}

TEST(FrameFeaturesTest, RefusesAMalformedImage) {
  RgbdImage image = SquaresImage(1);
  image.depth_m.release();
  EXPECT_EQ(MessageOf<InputError>([&] { FrameFeatures(image, *SmallCamera(), SmallExtractor()); }),
            "depth image is empty");
}

TEST(FrameFeaturesTest, RectifiedFeaturesLieWhereTheMiddleRowsMomentShowsThem) {
  const RgbdImage image = SquaresImage(1);  // 2 m away
  const CameraModel camera(SmallIntrinsics());
  const FrameFeatures frame(image, camera, SmallExtractor());
  const CameraTwist twist{{0.5, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  const double readout_s = 0.02;
  const auto rectified = frame.Rectified(twist, readout_s, camera);
  ASSERT_EQ(rectified->size(), frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const Feature& before = frame[i];
    const Feature& after = (*rectified)[i];
    EXPECT_EQ(after.exposed, before.exposed);
    EXPECT_EQ(after.raw, before.raw);
    // A row t later is seen from 0.5 t farther right and turned right by t: in the middle's moment
    // the point was farther right, by f (0.5 t / 2 m + t) where the view is straight ahead.
    const double t = readout_s * (before.raw.y() / 239.0 - 0.5);
    const double x = (before.pixel.x() - 159.5) / 260.0;
    const double shift_px = 260.0 * (0.25 * t + t * (1.0 + x * x));
    EXPECT_NEAR(after.pixel.x() - before.pixel.x(), shift_px, 0.1) << i;  // second order
  }
}

TEST(FrameFeaturesTest, WithoutMotionOrReadoutRectifyingChangesNothing) {
  const CameraModel camera = DistortedCamera();
  const FrameFeatures frame(SquaresImage(1), camera, SmallExtractor());
  const CameraTwist turning{{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}};
  const auto at_rest = frame.Rectified(CameraTwist(), 0.03, camera);
  const auto global = frame.Rectified(turning, 0.0, camera);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    // Back and forth through the ray: float rounding.
    EXPECT_LT(((*at_rest)[i].pixel - frame[i].pixel).norm(), 1e-3f);
    EXPECT_LT(((*global)[i].pixel - frame[i].pixel).norm(), 1e-3f);
  }
}

TEST(FrameFeaturesTest, RectifiedFeaturesAreFoundWhereTheyAreNow) {
  const CameraModel camera(SmallIntrinsics());
  const FrameFeatures frame(SquaresImage(1), camera, SmallExtractor());
  const auto rectified = frame.Rectified({{0.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}, 0.04, camera);
  for (const Feature& feature : rectified->features()) {
    EXPECT_EQ(Near(*rectified, feature.pixel, 10.0f, 0, 7),
              NearByLookingAtAll(*rectified, feature.pixel, 10.0f, 0, 7));
  }
}

TEST(FrameFeaturesTest, MadeOfTheirPartsTheyAreTheSame) {
  const auto original = SquaresFeatures(3);
  const FrameFeatures copy(original->stamp(), original->features(), original->descriptors(),
                           *SmallCamera());
  EXPECT_EQ(copy.stamp(), original->stamp());
  EXPECT_EQ(copy.descriptors(), original->descriptors());
  ASSERT_EQ(copy.size(), original->size());
  for (std::size_t i = 0; i < copy.size(); i += 10) {
    const Eigen::Vector2f& pixel = (*original)[i].pixel;
    EXPECT_EQ(Near(copy, pixel, 15.0f, 0, 7), Near(*original, pixel, 15.0f, 0, 7)) << i;
  }
}

}  // namespace
}  // namespace semantic_slam
