#include "semantic_slam/camera/rgbd_image.h"

#include <gtest/gtest.h>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

std::string ErrorOf(const cv::Mat& colour, const cv::Mat& depth_m) {
  RgbdImage image;
  image.colour = colour;
  image.depth_m = depth_m;
  return MessageOf<InputError>([&] { CheckRgbdImage(image); });
}

const cv::Mat kColour(480, 640, CV_8UC3);
const cv::Mat kDepth(480, 640, CV_32FC1);

TEST(RgbdImageTest, AcceptsWhatFitsTogether) {
  EXPECT_EQ(ErrorOf(kColour, kDepth), "");
}

TEST(RgbdImageTest, NamesTheEmptyImage) {
  EXPECT_EQ(ErrorOf({}, kDepth), "colour image is empty");
  EXPECT_EQ(ErrorOf(kColour, {}), "depth image is empty");
}

TEST(RgbdImageTest, NamesTheWrongType) {
  EXPECT_EQ(ErrorOf(cv::Mat(480, 640, CV_8UC1), kDepth),
            "colour image is CV_8UC1, expected CV_8UC3");
  EXPECT_EQ(ErrorOf(kColour, cv::Mat(480, 640, CV_16UC1)),
            "depth image is CV_16UC1, expected CV_32FC1 [m]");
}

TEST(RgbdImageTest, NamesBothSizes) {
  EXPECT_EQ(ErrorOf(kColour, cv::Mat(240, 320, CV_32FC1)),
            "depth image is [320 x 240] but colour image is [640 x 480]; is depth registered to "
            "colour?");
}

TEST(RgbdImageTest, NamesACalibrationForAnotherSize) {
  RgbdImage image;
  image.colour = kColour;
  image.depth_m = kDepth;
  const CameraModel fitting({640, 480, 500.0, 500.0, 319.5, 239.5, {}});
  const CameraModel other({320, 240, 250.0, 250.0, 159.5, 119.5, {}});
  EXPECT_NO_THROW(CheckRgbdImage(image, fitting));
  EXPECT_EQ(MessageOf<InputError>([&] { CheckRgbdImage(image, other); }),
            "image is [640 x 480] but the camera's calibration is for [320 x 240]");
}

}  // namespace
}  // namespace semantic_slam
