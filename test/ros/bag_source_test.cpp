#include "semantic_slam_ros/bag_source.h"

#include <cmath>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <sensor_msgs/image_encodings.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam_ros {
namespace {

namespace enc = sensor_msgs::image_encodings;
using semantic_slam::ColourOrder;
using semantic_slam::ExpectOneLineWith;
using semantic_slam::InputError;
using semantic_slam::MessageOf;

constexpr int kWidth = 16, kHeight = 12;
constexpr char kOptical[] = "/openni_rgb_optical_frame";  // as in 2011
const std::string kColourTopic = "/camera/rgb/image_color";
const std::string kDepthTopic = "/camera/depth/image";

Stamp Ms(std::int64_t ms) {
  return {(1'000'000 + ms) * 1'000'000};
}

cv::Mat Colour(int blue) {
  return {kHeight, kWidth, CV_8UC3, cv::Scalar(blue, 1, 2)};
}
cv::Mat DepthM(float metres) {
  return {kHeight, kWidth, CV_32FC1, cv::Scalar(metres)};
}

class BagSourceTest : public testing::Test {
 protected:
  // Writes a bag with what `write` puts into it. Returns its path.
  std::string Bag(const std::function<void(rosbag::Bag&)>& write) {
    const std::string path = folder_ / "test.bag";
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    write(bag);
    bag.close();
    return path;
  }

  static void AddImage(rosbag::Bag& bag, const std::string& topic, Stamp stamp,
                       const cv::Mat& image, const std::string& encoding) {
    const auto msg = ToImage(image, encoding, MakeHeader(stamp, kOptical));
    bag.write(topic, msg->header.stamp, *msg);
  }

  static void AddPair(rosbag::Bag& bag, int i) {
    AddImage(bag, kColourTopic, Ms(100 * i), Colour(i), enc::BGR8);
    AddImage(bag, kDepthTopic, Ms(100 * i + 5), DepthM(1.0f + static_cast<float>(i)),
             enc::TYPE_32FC1);
  }

  static std::string OpenError(const std::string& path) {
    return MessageOf<InputError>([&] { BagSource source(path); });
  }

  const semantic_slam::TemporaryFolder folder_;
};

TEST_F(BagSourceTest, ReadsRawPairsInOrder) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    for (int i = 0; i < 50; ++i) AddPair(bag, i);
  }));
  EXPECT_EQ(source.size(), 50u);
  for (int i = 0; i < 50; ++i) {
    const auto image = source.Next();
    ASSERT_TRUE(image) << i;
    EXPECT_EQ(image->stamp, Ms(100 * i));
    EXPECT_EQ(image->depth_stamp, Ms(100 * i + 5));
    EXPECT_EQ(image->order, ColourOrder::kBgr);
    EXPECT_EQ(image->colour.at<cv::Vec3b>(3, 3)[0], i);
    EXPECT_EQ(image->depth_m.at<float>(3, 3), 1.0f + static_cast<float>(i));
  }
  EXPECT_FALSE(source.Next());
  EXPECT_FALSE(source.Next());
  EXPECT_EQ(source.dropped(), 0u);
  EXPECT_TRUE(source.accelerometer().empty());
  EXPECT_TRUE(source.ground_truth().empty());
}

TEST_F(BagSourceTest, ReadsRealSenseTopicsWithDepthInMillimetres) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    AddImage(bag, "/camera/color/image_raw", Ms(0), Colour(1), enc::RGB8);
    AddImage(bag, "/camera/aligned_depth_to_color/image_raw", Ms(0),
             cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(1500)), enc::TYPE_16UC1);
  }));
  const auto image = source.Next();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->order, ColourOrder::kRgb);
  EXPECT_FLOAT_EQ(image->depth_m.at<float>(0, 0), 1.5f);
}

TEST_F(BagSourceTest, ReadsCompressedImages) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    sensor_msgs::CompressedImage msg;
    msg.header = MakeHeader(Ms(0), kOptical);
    msg.format = "bgr8; jpeg compressed bgr8";
    cv::imencode(".jpg", Colour(200), msg.data);
    bag.write(kColourTopic + "/compressed", msg.header.stamp, msg);
    msg.format = "16UC1; png compressed";
    cv::imencode(".png", cv::Mat(kHeight, kWidth, CV_16UC1, cv::Scalar(2000)), msg.data);
    bag.write(kDepthTopic + "/compressed", msg.header.stamp, msg);
  }));
  const auto image = source.Next();
  ASSERT_TRUE(image);
  EXPECT_NEAR(image->colour.at<cv::Vec3b>(3, 3)[0], 200, 3);
  EXPECT_FLOAT_EQ(image->depth_m.at<float>(0, 0), 2.0f);
}

TEST_F(BagSourceTest, ImagesOutliveTheSource) {
  std::optional<semantic_slam::RgbdImage> image;
  {
    BagSource source(Bag([](rosbag::Bag& bag) { AddPair(bag, 7); }));
    image = source.Next();
  }
  EXPECT_EQ(image->colour.at<cv::Vec3b>(11, 15)[0], 7);
}

TEST_F(BagSourceTest, PairsAStreamThatTheBagHoldsBack) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    for (int i = 0; i < 30; ++i) {
      const auto msg = ToImage(DepthM(1.0f), enc::TYPE_32FC1, MakeHeader(Ms(33 * i), kOptical));
      bag.write(kDepthTopic, ToRos(Ms(33 * i + 300)), *msg);  // received 0.3 s late
      AddImage(bag, kColourTopic, Ms(33 * i), Colour(i), enc::BGR8);
    }
  }));
  int pairs = 0;
  while (source.Next()) ++pairs;
  EXPECT_EQ(pairs, 30);
}

TEST_F(BagSourceTest, DropsAndReportsMalformedImages) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    AddPair(bag, 0);
    AddImage(bag, kColourTopic, Ms(100), Colour(1), enc::BGR8);
    AddImage(bag, kDepthTopic, Ms(100), cv::Mat(5, 5, CV_32FC1, cv::Scalar(1)), enc::TYPE_32FC1);
    AddImage(bag, kColourTopic, Ms(200), cv::Mat(kHeight, kWidth, CV_8UC1, cv::Scalar(1)),
             enc::BAYER_RGGB8);
    AddImage(bag, kDepthTopic, Ms(200), DepthM(1.0f), enc::TYPE_32FC1);
    auto truncated = ToImage(Colour(3), enc::BGR8, MakeHeader(Ms(300), kOptical));
    truncated->data.resize(10);
    bag.write(kColourTopic, truncated->header.stamp, *truncated);
    AddImage(bag, kDepthTopic, Ms(300), DepthM(1.0f), enc::TYPE_32FC1);
    AddPair(bag, 4);
  }));
  EXPECT_EQ(source.Next()->stamp, Ms(0));
  EXPECT_EQ(source.Next()->stamp, Ms(400));
  EXPECT_FALSE(source.Next());
  EXPECT_EQ(source.dropped(), 3u);
  ASSERT_EQ(source.problems().size(), 3u);
  ExpectOneLineWith(source.problems()[0], {"test.bag at 1000.100000", "[5 x 5]", "[16 x 12]"});
  ExpectOneLineWith(source.problems()[1], {"at 1000.200000", "bayer_rggb8"});
  ExpectOneLineWith(source.problems()[2], {"at 1000.300000", "10 bytes, expected 576"});
}

TEST_F(BagSourceTest, RefusesAMissingFileAndWhatIsNoBag) {
  EXPECT_EQ(OpenError("/nowhere/a.bag"), "no such file: /nowhere/a.bag");
  EXPECT_EQ(OpenError(folder_.path()), "no such file: " + folder_.path());
  ExpectOneLineWith(OpenError(folder_.Write("text.bag", "hello\nworld\n")),
                    {"text.bag is not a bag"});
  ExpectOneLineWith(OpenError(folder_.Write("empty.bag", "")), {"empty.bag is not a bag"});
}

TEST_F(BagSourceTest, RefusesATruncatedBag) {
  const std::string path = Bag([](rosbag::Bag& bag) {
    for (int i = 0; i < 50; ++i) AddPair(bag, i);
  });
  const auto size = std::filesystem::file_size(path);
  for (const double share : {0.02, 0.5, 0.95}) {
    std::filesystem::resize_file(path, static_cast<std::uintmax_t>(share * double(size)));
    const std::string message = MessageOf<InputError>([&] {
      BagSource source(path);
      while (source.Next()) continue;
    });
    ExpectOneLineWith(message, {path.c_str()});
    Bag([](rosbag::Bag& bag) {
      for (int i = 0; i < 50; ++i) AddPair(bag, i);
    });
  }
}

TEST_F(BagSourceTest, SaysWhichTopicsThereAreInsteadOfImages) {
  EXPECT_EQ(OpenError(Bag([](rosbag::Bag&) {})),
            folder_ / "test.bag" +
                " has no colour images; looked for /camera/rgb/image_color, "
                "/camera/color/image_raw, /camera/rgb/image_rect_color, "
                "/camera/rgb/image_raw; found nothing");
  const std::string path = Bag([](rosbag::Bag& bag) {
    AddImage(bag, kColourTopic, Ms(0), Colour(1), enc::BGR8);
    bag.write(kDepthTopic, ToRos(Ms(0)), std_msgs::String());
  });
  ExpectOneLineWith(OpenError(path),
                    {"has no depth images", "/camera/depth/image (std_msgs/String)",
                     "/camera/rgb/image_color (sensor_msgs/Image)"});
}

TEST_F(BagSourceTest, TopicsAreAnOption) {
  const std::string path = Bag([](rosbag::Bag& bag) {
    AddImage(bag, "/left", Ms(0), Colour(1), enc::BGR8);
    AddImage(bag, "/range", Ms(0), DepthM(1.0f), enc::TYPE_32FC1);
  });
  BagTopics topics;
  topics.colour = {"/left"};
  topics.depth = {"/range"};
  EXPECT_TRUE(BagSource(path, topics).Next());
}

TEST_F(BagSourceTest, RefusesImagesThatNeverPair) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    for (int i = 0; i < 3; ++i) {
      AddImage(bag, kColourTopic, Ms(100 * i), Colour(i), enc::BGR8);
      AddImage(bag, kDepthTopic, Ms(100 * i + 50), DepthM(1.0f), enc::TYPE_32FC1);
    }
  }));
  ExpectOneLineWith(MessageOf<InputError>([&] { source.Next(); }),
                    {"none of 3 colour and 3 depth images"});
}

TEST_F(BagSourceTest, RefusesStampsThatJumpBack) {
  BagSource source(Bag([](rosbag::Bag& bag) {
    AddPair(bag, 50);
    for (const int ms : {0, 33, 66}) {
      const auto msg = ToImage(Colour(0), enc::BGR8, MakeHeader(Ms(ms), kOptical));
      bag.write(kColourTopic, ToRos(Ms(9000 + ms)), *msg);
    }
  }));
  ExpectOneLineWith(MessageOf<InputError>([&] {
                      while (source.Next()) continue;
                    }),
                    {"jump back to 1000.066000"});
}

TEST_F(BagSourceTest, ReadsTheCalibrationAndNamesOneOfZeros) {
  const semantic_slam::CameraIntrinsics intrinsics{kWidth, kHeight, 20, 20, 8, 6, {}};
  const auto with_info = [&](double k_scale) {
    return Bag([&](rosbag::Bag& bag) {
      AddPair(bag, 0);
      auto msg = ToCameraInfo(intrinsics, MakeHeader(Ms(0), kOptical));
      for (double& k : msg.K) k *= k_scale;
      bag.write("/camera/rgb/camera_info", msg.header.stamp, msg);
    });
  };
  EXPECT_EQ(BagSource(with_info(1.0)).Intrinsics().fx_px, 20.0);
  const BagSource uncalibrated(with_info(0.0));
  ExpectOneLineWith(MessageOf<InputError>([&] { uncalibrated.Intrinsics(); }),
                    {"openni_rgb_optical_frame' is not calibrated (K is 0)"});
  const BagSource without(Bag([](rosbag::Bag& bag) { AddPair(bag, 0); }));
  ExpectOneLineWith(MessageOf<InputError>([&] { without.Intrinsics(); }), {"has no camera_info"});
}

TEST_F(BagSourceTest, ComposesGroundTruthAndImuFromTf) {
  const Rigid3d T_kinect_camera =
      Eigen::Translation3d(0.1, 0.2, 0.3) * Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX());
  Rigid3d T_camera_imu = Rigid3d::Identity();
  T_camera_imu.linear() = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  const auto world_pose = [](int i) {
    return Rigid3d(Eigen::Translation3d(0.1 * i, 0.0, 1.0) *
                   Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitZ()));
  };
  const BagSource source(Bag([&](rosbag::Bag& bag) {
    AddPair(bag, 0);
    for (int i = 0; i < 10; ++i) {
      tf2_msgs::TFMessage msg;
      msg.transforms = {ToTransformStamped(Ms(10 * i), "/world", "/kinect", world_pose(i)),
                        ToTransformStamped(Ms(10 * i), "/kinect", kOptical, T_kinect_camera),
                        ToTransformStamped(Ms(10 * i), kOptical, "/imu", T_camera_imu)};
      bag.write("/tf", ToRos(Ms(10 * i)), msg);
      msg.transforms.front().transform.rotation.w = NAN;  // left out
      msg.transforms.resize(1);
      bag.write("/tf", ToRos(Ms(10 * i)), msg);
      sensor_msgs::Imu imu;
      imu.header = MakeHeader(Ms(10 * i), "/imu");
      imu.linear_acceleration.z = 9.81;
      bag.write("/imu", imu.header.stamp, imu);
    }
  }));
  ASSERT_EQ(source.ground_truth().size(), 10u);
  EXPECT_TRUE(source.ground_truth()[3].pose.isApprox(world_pose(3) * T_kinect_camera, 1e-9));
  EXPECT_EQ(source.accelerometer().size(), 10u);
  ASSERT_TRUE(source.R_camera_imu());
  EXPECT_TRUE(source.R_camera_imu()->isApprox(T_camera_imu.linear(), 1e-9));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
