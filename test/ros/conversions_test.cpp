#include "semantic_slam_ros/conversions.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>
#include <boost/make_shared.hpp>
#include <boost/weak_ptr.hpp>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam_ros {
namespace {

namespace enc = sensor_msgs::image_encodings;
using semantic_slam::CameraIntrinsics;
using semantic_slam::ColourOrder;
using semantic_slam::InputError;
using semantic_slam::MessageOf;

const double kNan = std::numeric_limits<double>::quiet_NaN();

// 3 x 2 pixels of the encoding; byte i has the value i.
sensor_msgs::ImagePtr SmallImage(const std::string& encoding, std::uint32_t pixel_bytes) {
  auto msg = boost::make_shared<sensor_msgs::Image>();
  msg->encoding = encoding;
  msg->width = 3;
  msg->height = 2;
  msg->step = 3 * pixel_bytes;
  msg->data.resize(msg->step * msg->height);
  for (std::size_t i = 0; i < msg->data.size(); ++i) msg->data[i] = static_cast<std::uint8_t>(i);
  return msg;
}

template <typename Value>
sensor_msgs::ImagePtr DepthImage(const std::string& encoding, const std::vector<Value>& values) {
  auto msg = SmallImage(encoding, sizeof(Value));
  std::memcpy(msg->data.data(), values.data(), msg->data.size());
  return msg;
}

std::string ColourError(const sensor_msgs::ImagePtr& msg) {
  return MessageOf<InputError>([&] { ToColour(sensor_msgs::ImageConstPtr(msg)); });
}
std::string DepthError(const sensor_msgs::ImagePtr& msg) {
  return MessageOf<InputError>([&] { ToDepthMetres(sensor_msgs::ImageConstPtr(msg)); });
}

TEST(StampConversionTest, IsExactBothWays) {
  const Stamp stamp{1305031453359684001};
  EXPECT_EQ(ToRos(stamp).sec, 1305031453u);
  EXPECT_EQ(ToRos(stamp).nsec, 359684001u);
  EXPECT_EQ(ToStamp(ToRos(stamp)), stamp);
  EXPECT_EQ(ToStamp(ros::TIME_MAX).ns / 1'000'000'000, std::numeric_limits<std::uint32_t>::max());
}

TEST(FrameNameTest, HasNoLeadingSlash) {
  EXPECT_EQ(FrameName("/camera"), "camera");
  EXPECT_EQ(FrameName("camera/optical"), "camera/optical");
  EXPECT_EQ(FrameName("//"), "");
  EXPECT_EQ(FrameName(""), "");
}

TEST(ColourConversionTest, SharesThePixelsOfThreeChannelImages) {
  for (const auto& [encoding, order] :
       {std::pair(enc::RGB8, ColourOrder::kRgb), std::pair(enc::BGR8, ColourOrder::kBgr),
        std::pair(enc::TYPE_8UC3, ColourOrder::kBgr)}) {
    const sensor_msgs::ImageConstPtr msg = SmallImage(encoding, 3);
    const ColourImage colour = ToColour(msg);
    EXPECT_EQ(colour.pixels.data, msg->data.data());
    EXPECT_EQ(colour.order, order);
    EXPECT_EQ(colour.pixels.at<cv::Vec3b>(1, 2), cv::Vec3b(15, 16, 17));
  }
}

TEST(ColourConversionTest, SharedPixelsKeepTheMessageAlive) {
  sensor_msgs::ImageConstPtr msg = SmallImage(enc::BGR8, 3);
  const boost::weak_ptr<const sensor_msgs::Image> watch = msg;
  cv::Mat pixels = ToColour(msg).pixels;
  msg.reset();
  const cv::Mat part = pixels.row(1);
  EXPECT_FALSE(watch.expired());
  pixels.release();
  EXPECT_EQ(part.at<cv::Vec3b>(0, 0), cv::Vec3b(9, 10, 11));
  const cv::Mat copy = part.clone();
  EXPECT_FALSE(watch.expired());
  const_cast<cv::Mat&>(part).release();
  EXPECT_TRUE(watch.expired());
  EXPECT_EQ(copy.at<cv::Vec3b>(0, 0), cv::Vec3b(9, 10, 11));
}

TEST(ColourConversionTest, RespectsPaddedRows) {
  auto msg = SmallImage(enc::BGR8, 3);
  msg->step = 12;
  msg->data.assign(24, 0);
  msg->data[12] = 7;
  const cv::Mat pixels = ToColour(sensor_msgs::ImageConstPtr(msg)).pixels;
  EXPECT_EQ(pixels.at<cv::Vec3b>(1, 0), cv::Vec3b(7, 0, 0));
}

TEST(ColourConversionTest, ConvertsFourChannelsAndGreyToBgr) {
  const auto first_pixel = [](const std::string& encoding, std::uint32_t bytes) {
    const ColourImage colour = ToColour(sensor_msgs::ImageConstPtr(SmallImage(encoding, bytes)));
    EXPECT_EQ(colour.order, ColourOrder::kBgr);
    return colour.pixels.at<cv::Vec3b>(0, 1);
  };
  EXPECT_EQ(first_pixel(enc::RGBA8, 4), cv::Vec3b(6, 5, 4));
  EXPECT_EQ(first_pixel(enc::BGRA8, 4), cv::Vec3b(4, 5, 6));
  EXPECT_EQ(first_pixel(enc::MONO8, 1), cv::Vec3b(1, 1, 1));
}

TEST(ColourConversionTest, RefusesOtherEncodings) {
  EXPECT_EQ(ColourError(SmallImage(enc::BAYER_RGGB8, 1)),
            "colour encoding is 'bayer_rggb8'; debayer it first (image_proc does)");
  EXPECT_EQ(ColourError(SmallImage("16UC1", 2)),
            "colour encoding is '16UC1', expected rgb8, bgr8, rgba8, bgra8 or mono8");
  EXPECT_EQ(ColourError(SmallImage("", 3)),
            "colour encoding is '', expected rgb8, bgr8, rgba8, bgra8 or mono8");
}

TEST(ColourConversionTest, RefusesPixelsThatAreNotAllThere) {
  auto msg = SmallImage(enc::BGR8, 3);
  msg->data.pop_back();
  EXPECT_EQ(ColourError(msg), "3 x 2 bgr8 image has 17 bytes, expected 18");
  msg = SmallImage(enc::BGR8, 3);
  msg->step = 8;
  EXPECT_EQ(ColourError(msg), "step of a 3 x 2 bgr8 image is 8, expected 9");
  msg = SmallImage(enc::BGR8, 3);
  msg->height = 0;
  EXPECT_EQ(ColourError(msg), "image size is 3 x 0");
  // Step times height is 2^32 and would wrap to the zero bytes that are there.
  msg->width = 16, msg->height = 16384, msg->step = 1u << 18;
  msg->data.clear();
  EXPECT_EQ(ColourError(msg), "16 x 16384 bgr8 image has 0 bytes, expected 4294967296");
  msg->width = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(ColourError(msg), "image size is 4294967295 x 16384");
}

TEST(DepthConversionTest, SharesMetres) {
  const sensor_msgs::ImageConstPtr msg =
      DepthImage<float>(enc::TYPE_32FC1, {0.5f, NAN, 1.5f, 2.0f, 2.5f, 3.0f});
  const cv::Mat depth_m = ToDepthMetres(msg);
  EXPECT_EQ(depth_m.data, msg->data.data());
  EXPECT_EQ(depth_m.type(), CV_32FC1);
  EXPECT_EQ(depth_m.at<float>(1, 2), 3.0f);
}

TEST(DepthConversionTest, ConvertsMillimetresWithZeroAsNoReturn) {
  for (const std::string& encoding : {enc::TYPE_16UC1, enc::MONO16}) {
    const auto msg = DepthImage<std::uint16_t>(encoding, {0, 1, 1000, 2000, 65535, 0});
    const cv::Mat depth_m = ToDepthMetres(sensor_msgs::ImageConstPtr(msg));
    EXPECT_TRUE(std::isnan(depth_m.at<float>(0, 0)));
    EXPECT_FLOAT_EQ(depth_m.at<float>(0, 2), 1.0f);
    EXPECT_FLOAT_EQ(depth_m.at<float>(1, 1), 65.535f);
  }
}

TEST(DepthConversionTest, RefusesOtherEncodingsAndBadLayouts) {
  EXPECT_EQ(DepthError(SmallImage(enc::BGR8, 3)),
            "depth encoding is 'bgr8', expected 32FC1 [m] or 16UC1 [mm]");
  auto msg = SmallImage(enc::TYPE_16UC1, 2);
  msg->is_bigendian = 1;
  EXPECT_EQ(DepthError(msg), "big-endian 16UC1 images are not supported");
  msg = SmallImage(enc::TYPE_32FC1, 4);
  msg->step = 13;
  msg->data.resize(26);
  EXPECT_EQ(DepthError(msg), "step of a 3 x 2 32FC1 image is 13, expected 12");
}

sensor_msgs::CompressedImage Compressed(const cv::Mat& image, const std::string& extension,
                                        const std::string& format) {
  sensor_msgs::CompressedImage msg;
  msg.format = format;
  cv::imencode(extension, image, msg.data);
  return msg;
}

template <typename Convert>
std::string CompressedError(const sensor_msgs::CompressedImage& msg, Convert convert) {
  return MessageOf<InputError>([&] { convert(msg); });
}
const auto kToColour = [](const sensor_msgs::CompressedImage& msg) { ToColour(msg); };
const auto kToDepth = [](const sensor_msgs::CompressedImage& msg) { ToDepthMetres(msg); };

TEST(CompressedConversionTest, DecodesColourToBgr) {
  const cv::Mat image(4, 4, CV_8UC3, cv::Scalar(200, 100, 50));
  for (const char* extension : {".png", ".jpg"}) {
    const ColourImage colour = ToColour(Compressed(image, extension, "rgb8; jpeg compressed bgr8"));
    EXPECT_EQ(colour.order, ColourOrder::kBgr);
    EXPECT_NEAR(colour.pixels.at<cv::Vec3b>(1, 1)[0], 200, 3);
    EXPECT_NEAR(colour.pixels.at<cv::Vec3b>(1, 1)[2], 50, 3);
  }
}

TEST(CompressedConversionTest, DecodesPlainDepthPng) {
  const cv::Mat image(4, 4, CV_16UC1, cv::Scalar(1500));
  const cv::Mat depth_m = ToDepthMetres(Compressed(image, ".png", "16UC1; png compressed"));
  EXPECT_FLOAT_EQ(depth_m.at<float>(0, 0), 1.5f);
}

// What compressed_depth_image_transport sends: a header of 12 bytes, then a PNG.
sensor_msgs::CompressedImage CompressedDepth(const cv::Mat& image, const std::string& format,
                                             float quant_a, float quant_b) {
  sensor_msgs::CompressedImage msg = Compressed(image, ".png", format);
  const float header[] = {0.0f, quant_a, quant_b};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(header);
  msg.data.insert(msg.data.begin(), bytes, bytes + sizeof(header));
  return msg;
}

TEST(CompressedConversionTest, DecodesCompressedDepthOfMillimetres) {
  const cv::Mat image = (cv::Mat_<std::uint16_t>(1, 3) << 0, 1000, 2500);
  const cv::Mat depth_m =
      ToDepthMetres(CompressedDepth(image, "16UC1; compressedDepth png", 0.0f, 0.0f));
  EXPECT_TRUE(std::isnan(depth_m.at<float>(0, 0)));
  EXPECT_FLOAT_EQ(depth_m.at<float>(0, 2), 2.5f);
}

TEST(CompressedConversionTest, DecodesCompressedDepthOfMetres) {
  // The transport stores a / depth + b: with a = 1000, b = 10 two metres are 510.
  const cv::Mat image = (cv::Mat_<std::uint16_t>(1, 2) << 0, 510);
  const cv::Mat depth_m =
      ToDepthMetres(CompressedDepth(image, "32FC1; compressedDepth", 1000.0f, 10.0f));
  EXPECT_TRUE(std::isnan(depth_m.at<float>(0, 0)));
  EXPECT_FLOAT_EQ(depth_m.at<float>(0, 1), 2.0f);
}

TEST(CompressedConversionTest, RefusesWhatCannotBeDecoded) {
  sensor_msgs::CompressedImage msg = Compressed(cv::Mat(40, 40, CV_8UC3), ".jpg", "jpeg");
  msg.data.resize(msg.data.size() / 2);
  EXPECT_NE(CompressedError(msg, kToColour), "");
  msg.data.clear();
  EXPECT_EQ(CompressedError(msg, kToColour),
            "cannot decode a compressed image of format 'jpeg', 0 bytes");
  msg.format = "16UC1; compressedDepth";
  msg.data.assign(5, 0);  // less than the header
  EXPECT_NE(CompressedError(msg, kToDepth), "");
  msg.format = "bayer_rggb8; jpeg compressed";
  EXPECT_EQ(CompressedError(msg, kToColour),
            "compressed colour image is 'bayer_rggb8; jpeg compressed'; debayer it first");
}

TEST(CompressedConversionTest, RefusesDepthThatIsNot16Bit) {
  EXPECT_EQ(CompressedError(Compressed(cv::Mat(4, 4, CV_8UC1), ".png", "png"), kToDepth),
            "compressed depth of format 'png' is CV_8UC1, expected a 16-bit PNG");
}

const CameraIntrinsics kIntrinsics{
    640, 480, 517.3, 516.5, 318.6, 255.3, {0.26, -0.95, -0.005, 0.003, 1.16}};

std::string InfoError(const sensor_msgs::CameraInfo& msg) {
  return MessageOf<InputError>([&] { ToIntrinsics(msg); });
}

sensor_msgs::CameraInfo GoodInfo() {
  return ToCameraInfo(kIntrinsics, MakeHeader({}, "/camera"));
}

TEST(CameraInfoConversionTest, ReadsBackWhatItWrites) {
  EXPECT_TRUE(ToIntrinsics(GoodInfo()) == kIntrinsics);
  EXPECT_EQ(GoodInfo().distortion_model, "plumb_bob");
  EXPECT_EQ(GoodInfo().P[0], 517.3);
  CameraIntrinsics rational = kIntrinsics;
  rational.distortion.resize(8, 0.1);
  EXPECT_TRUE(ToIntrinsics(ToCameraInfo(rational, {})) == rational);
}

TEST(CameraInfoConversionTest, RefusesACameraWithoutCalibrationByName) {
  sensor_msgs::CameraInfo msg = GoodInfo();
  msg.K.fill(0.0);
  EXPECT_EQ(InfoError(msg), "camera_info in frame 'camera' is not calibrated (K is 0)");
}

TEST(CameraInfoConversionTest, RefusesWhatItCannotUse) {
  sensor_msgs::CameraInfo msg = GoodInfo();
  msg.K[2] = kNan;
  EXPECT_EQ(InfoError(msg), "camera_info in frame 'camera' has a K that is not finite");
  msg = GoodInfo();
  msg.distortion_model = "equidistant";
  EXPECT_EQ(InfoError(msg),
            "camera_info in frame 'camera' has distortion model 'equidistant', expected plumb_bob "
            "or rational_polynomial");
  msg = GoodInfo();
  msg.D = {0.1, 0.2};
  semantic_slam::ExpectOneLineWith(InfoError(msg), {"is not usable", "2 coefficients"});
  msg = GoodInfo();
  msg.width = 0;
  semantic_slam::ExpectOneLineWith(InfoError(msg), {"is not usable", "width_px = 0"});
  msg = GoodInfo();
  msg.binning_x = 2;
  semantic_slam::ExpectOneLineWith(InfoError(msg), {"binning"});
  msg = GoodInfo();
  msg.roi.width = 320;
  semantic_slam::ExpectOneLineWith(InfoError(msg), {"region of interest"});
}

TEST(CameraInfoConversionTest, AnEmptyModelWithoutCoefficientsIsNoDistortion) {
  sensor_msgs::CameraInfo msg = GoodInfo();
  msg.D.clear();
  msg.distortion_model.clear();
  EXPECT_TRUE(ToIntrinsics(msg).distortion.empty());
}

TEST(TransformConversionTest, ReadsBackWhatItWrites) {
  const Rigid3d T = Eigen::Translation3d(1.0, -2.0, 3.0) *
                    Eigen::AngleAxisd(2.5, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
  EXPECT_TRUE(ToRigid(ToPose(T)).isApprox(T, 1e-12));
  EXPECT_TRUE(ToRigid(ToTransform(T)).isApprox(T, 1e-12));
  const auto stamped = ToTransformStamped({2'000'000'001}, "map", "odom", T);
  EXPECT_EQ(stamped.header.frame_id, "map");
  EXPECT_EQ(stamped.child_frame_id, "odom");
  EXPECT_EQ(stamped.header.stamp.nsec, 1u);
}

TEST(TransformConversionTest, RefusesWhatIsNoTransform) {
  geometry_msgs::Pose pose;  // a message starts with a quaternion of zeros
  EXPECT_EQ(MessageOf<InputError>([&] { ToRigid(pose); }),
            "transform's quaternion has length 0.000000, expected 1");
  pose.orientation.w = 1.0;
  pose.position.x = kNan;
  EXPECT_EQ(MessageOf<InputError>([&] { ToRigid(pose); }),
            "transform has a number that is not finite");
}

TEST(ImuConversionTest, TakesTheAcceleration) {
  sensor_msgs::Imu msg;
  msg.header.stamp = ros::Time(3, 4);
  msg.linear_acceleration.y = 9.81;
  const auto reading = ToAccelerometerReading(msg);
  EXPECT_EQ(reading.stamp.ns, 3'000'000'004);
  EXPECT_EQ(reading.acceleration_imu, Eigen::Vector3d(0.0, 9.81, 0.0));
  msg.linear_acceleration.x = kNan;
  EXPECT_NE(MessageOf<InputError>([&] { ToAccelerometerReading(msg); }), "");
  msg.linear_acceleration.x = 0.0;
  msg.linear_acceleration_covariance[0] = -1.0;
  EXPECT_EQ(MessageOf<InputError>([&] { ToAccelerometerReading(msg); }),
            "imu message says that it has no acceleration");
}

TEST(ImageMessageTest, ReadsBackWhatItWrites) {
  cv::Mat big(4, 6, CV_8UC3);
  cv::randu(big, 0, 255);
  const ColourImage part{big(cv::Rect(1, 1, 3, 2)), ColourOrder::kRgb};  // rows with a gap
  const auto msg = ToImage(part, MakeHeader({5}, "camera"));
  EXPECT_EQ(msg->encoding, enc::RGB8);
  EXPECT_EQ(msg->step, 9u);
  const ColourImage back = ToColour(sensor_msgs::ImageConstPtr(msg));
  EXPECT_EQ(back.order, ColourOrder::kRgb);
  EXPECT_EQ(cv::norm(back.pixels, part.pixels, cv::NORM_L1), 0.0);
}

TEST(ImageMessageTest, EitherTransportIsAnImageMessage) {
  const ImageMessage raw = sensor_msgs::ImageConstPtr(SmallImage(enc::BGR8, 3));
  EXPECT_EQ(ToColour(raw).pixels.size(), cv::Size(3, 2));
  const ImageMessage compressed = boost::make_shared<const sensor_msgs::CompressedImage>(
      Compressed(cv::Mat(4, 4, CV_16UC1, cv::Scalar(1)), ".png", "png"));
  EXPECT_EQ(ToDepthMetres(compressed).size(), cv::Size(4, 4));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
