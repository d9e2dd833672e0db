#include "semantic_slam/semantic_cloud/cloud_builder.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

CameraIntrinsics SmallCamera() {
  CameraIntrinsics intrinsics;
  intrinsics.width_px = 32;
  intrinsics.height_px = 24;
  intrinsics.fx_px = intrinsics.fy_px = 30.0;
  intrinsics.cx_px = 15.5;
  intrinsics.cy_px = 11.5;
  return intrinsics;
}

RgbdImage Image(float depth_m, const cv::Size& size = {32, 24}) {
  RgbdImage image;
  image.stamp = image.depth_stamp = Stamp{1000};
  image.colour = cv::Mat(size, CV_8UC3, cv::Scalar(10, 20, 30));
  image.depth_m = cv::Mat(size, CV_32FC1, cv::Scalar(depth_m));
  return image;
}

Segmentation Labels(const RgbdImage& image) {
  Segmentation segmentation;
  segmentation.stamp = image.stamp;
  segmentation.vocabulary_hash = 42;
  for (int i = 0; i < kTopLabels; ++i) {
    segmentation.labels[i] = cv::Mat(image.colour.size(), CV_8UC1, cv::Scalar(i + 1));
    segmentation.confidences[i] = cv::Mat(image.colour.size(), CV_8UC1, cv::Scalar(102 >> i));
  }
  return segmentation;
}

CloudBuilder Builder(CloudBuilderOptions options,
                     const CameraIntrinsics& intrinsics = SmallCamera()) {
  return CloudBuilder(options, std::make_shared<const CameraModel>(intrinsics));
}

CloudBuilderOptions EveryPixel() {
  CloudBuilderOptions options;
  options.stride_px = 1;
  return options;
}

TEST(CloudBuilderTest, APointCarriesItsPixelsColourLabelsAndConfidences) {
  const RgbdImage image = Image(2.0f);
  const SemanticCloud cloud = Builder(EveryPixel()).Build(image, Labels(image));
  EXPECT_EQ(cloud.stamp, image.stamp);
  EXPECT_EQ(cloud.vocabulary_hash, 42u);
  ASSERT_EQ(cloud.points.size(), 32u * 24u);
  const SemanticPoint& point = cloud.points[32 * 3 + 5];           // row 3, column 5
  EXPECT_NEAR(point.position.x(), (5 - 15.5) / 30.0 * 2.0, 1e-6);  // rounding of a float
  EXPECT_NEAR(point.position.y(), (3 - 11.5) / 30.0 * 2.0, 1e-6);
  EXPECT_EQ(point.position.z(), 2.0f);
  EXPECT_EQ(point.rgb, (std::array<std::uint8_t, 3>{30, 20, 10}));
  EXPECT_EQ(point.labels, (std::array<LabelId, 3>{1, 2, 3}));
  EXPECT_FLOAT_EQ(point.confidences[0], 0.4f);
  EXPECT_FLOAT_EQ(point.confidences[1], 0.2f);
  EXPECT_FLOAT_EQ(point.confidences[2], 25.0f / 255.0f);
}

TEST(CloudBuilderTest, ReadsRgbOrderToo) {
  RgbdImage image = Image(2.0f);
  image.order = ColourOrder::kRgb;
  const SemanticCloud cloud = Builder(EveryPixel()).Build(image, Labels(image));
  EXPECT_EQ(cloud.points[0].rgb, (std::array<std::uint8_t, 3>{10, 20, 30}));
}

// The distortion is in it: a point projects back to the raw pixel that it came from.
TEST(CloudBuilderTest, PointsProjectBackToTheirRawPixels) {
  const TexturedRoom room;
  const auto camera = std::make_shared<const CameraModel>(room.camera().intrinsics());
  ASSERT_FALSE(camera->intrinsics().distortion.empty());
  CloudBuilderOptions options;
  options.stride_px = 16;
  options.max_depth_jump = 0.0;
  const RgbdImage image = Image(1.5f, {camera->width_px(), camera->height_px()});
  const SemanticCloud cloud = CloudBuilder(options, camera).Build(image, Labels(image));
  ASSERT_EQ(cloud.points.size(), 40u * 30u);
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 40; ++column) {
      const Eigen::Vector2d pixel =
          camera->ProjectRaw(cloud.points[40 * row + column].position.cast<double>());
      // The ray table is float, and its undistortion stops at 1e-9.
      EXPECT_NEAR(pixel.x(), 8 + 16 * column, 1e-3);
      EXPECT_NEAR(pixel.y(), 8 + 16 * row, 1e-3);
    }
  }
}

TEST(CloudBuilderTest, DropsWhatIsNoDepth) {
  for (const float depth : {kNan, kInfinity, -kInfinity, 0.0f, -1.0f, 0.29f, 5.1f}) {
    RgbdImage image = Image(2.0f);
    image.depth_m.at<float>(7, 9) = depth;
    CloudBuilderOptions options = EveryPixel();
    options.max_depth_jump = 0.0;
    EXPECT_EQ(Builder(options).Build(image, Labels(image)).points.size(), 32u * 24u - 1) << depth;
    image.depth_m.setTo(depth);
    EXPECT_TRUE(Builder(options).Build(image, Labels(image)).points.empty()) << depth;
  }
}

TEST(CloudBuilderTest, StrideTakesEveryNthPixelFromTheMiddleOfTheFirstCell) {
  RgbdImage image = Image(2.0f);
  CloudBuilderOptions options;
  options.stride_px = 4;
  const SemanticCloud cloud = Builder(options).Build(image, Labels(image));
  ASSERT_EQ(cloud.points.size(), 8u * 6u);
  EXPECT_NEAR(cloud.points[0].position.x(), (2 - 15.5) / 30.0 * 2.0, 1e-6);  // rounding of a float
}

TEST(CloudBuilderTest, DropsBothSidesOfADepthEdge) {
  RgbdImage image = Image(2.0f);
  image.depth_m.colRange(16, 32).setTo(3.0f);
  image.depth_m.rowRange(0, 1).setTo(kNan);  // a missing neighbour is no edge
  const SemanticCloud cloud = Builder(EveryPixel()).Build(image, Labels(image));
  EXPECT_EQ(cloud.points.size(), 23u * 30u);
  for (const SemanticPoint& point : cloud.points) {
    const double u = point.position.x() / point.position.z() * 30.0 + 15.5;
    EXPECT_TRUE(u < 14.5 || u > 16.5) << u;
  }
}

TEST(CloudBuilderTest, ASlopeBelowTheJumpStays) {
  RgbdImage image = Image(2.0f);
  for (int u = 0; u < 32; ++u) image.depth_m.col(u).setTo(2.0 + 0.05 * u);  // 2.5 % a pixel
  EXPECT_EQ(Builder(EveryPixel()).Build(image, Labels(image)).points.size(), 32u * 24u);
}

TEST(CloudBuilderTest, DropsSurfacesSeenAtAGrazingAngle) {
  // A floor 1 m below the camera: row v is seen at an incidence of atan(1 / slope), 79.6 degrees
  // where y / z = 0.183, and this camera has rows from 0.017 to 0.383.
  RgbdImage image = Image(kNan);
  for (int v = 12; v < 24; ++v) image.depth_m.row(v).setTo(30.0 / (v - 11.5));
  CloudBuilderOptions options = EveryPixel();
  options.max_depth_m = 30.0;
  options.max_depth_jump = 0.0;
  const std::size_t all = Builder(options).Build(image, Labels(image)).points.size();
  options.max_incidence_deg = 75.0;
  const SemanticCloud cloud = Builder(options).Build(image, Labels(image));
  EXPECT_LT(cloud.points.size(), all);
  EXPECT_GT(cloud.points.size(), 0u);
  for (const SemanticPoint& point : cloud.points) {
    const Eigen::Vector3f ray = point.position.normalized();
    // Rows near the border of the missing half cannot be judged, and stay.
    if (point.position.y() / point.position.z() > 0.15f) {
      EXPECT_GE(ray.y(), std::cos(75.0 * M_PI / 180.0) - 1e-3);
    }
  }
}

TEST(CloudBuilderTest, GivesTheSamePointsForMillimetresAndMetres) {
  RgbdImage metres = Image(2.0f), millimetres = Image(2.0f);
  cv::Mat raw(24, 32, CV_16UC1);
  for (int i = 0; i < 24 * 32; ++i)
    raw.at<std::uint16_t>(i / 32, i % 32) = static_cast<std::uint16_t>(1500 + i);
  raw.convertTo(millimetres.depth_m, CV_32F, 0.001);
  for (int i = 0; i < 24 * 32; ++i)
    metres.depth_m.at<float>(i / 32, i % 32) = static_cast<float>((1500 + i) * 0.001);
  const auto a = Builder(EveryPixel()).Build(metres, Labels(metres));
  const auto b = Builder(EveryPixel()).Build(millimetres, Labels(millimetres));
  ASSERT_EQ(a.points.size(), b.points.size());
  ASSERT_GT(a.points.size(), 500u);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    // The product with 0.001 was rounded to float in the one, to double first in the other.
    EXPECT_TRUE(a.points[i].position.isApprox(b.points[i].position, 2e-7f));
  }
}

TEST(CloudBuilderTest, RefusesASegmentationOfAnotherImage) {
  const RgbdImage image = Image(2.0f);
  const CloudBuilder builder = Builder({});
  Segmentation late = Labels(image);
  late.stamp.ns += 1;
  EXPECT_NE(MessageOf<InputError>([&] {
              builder.Build(image, late);
            }).find("segmentation is of the image at"),
            std::string::npos);
  Segmentation small = Labels(image);
  small.labels[1] = cv::Mat::zeros(12, 16, CV_8UC1);
  EXPECT_NE(MessageOf<InputError>([&] { builder.Build(image, small); }).find("16 x 12 px"),
            std::string::npos);
  Segmentation wide = Labels(image);
  wide.confidences[2].convertTo(wide.confidences[2], CV_32F);
  EXPECT_NE(MessageOf<InputError>([&] { builder.Build(image, wide); }).find("CV_32FC1"),
            std::string::npos);
  EXPECT_NE(MessageOf<InputError>([&] { builder.Build(image, Segmentation{}); }), "");
}

TEST(CloudBuilderTest, RefusesAnImageThatIsNotTheCameras) {
  const RgbdImage image = Image(2.0f, {64, 48});
  EXPECT_NE(MessageOf<InputError>([&] { Builder({}).Build(image, Labels(image)); }), "");
  EXPECT_NE(MessageOf<InputError>([&] { Builder({}).Build(RgbdImage{}, Segmentation{}); }), "");
}

TEST(CloudBuilderTest, ChecksItsOptions) {
  CloudBuilderOptions options;
  options.min_depth_m = 6.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { Builder(options); }),
            "min_depth_m = 6, but must be below max_depth_m = 5");
  options.stride_px = 0;
  EXPECT_NE(MessageOf<ConfigError>([&] { Builder(options); }).find("stride_px = 0"),
            std::string::npos);
}

}  // namespace
}  // namespace semantic_slam
