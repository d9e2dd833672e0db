#include "semantic_slam/dataset/tum_folder_writer.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

CameraConfig SmallConfig() {
  CameraConfig config;
  config.intrinsics = {8, 8, 7.5, 7.25, 3.5, 3.25, {0.1, -0.2, 0.0, 0.0}};
  config.R_camera_imu = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  return config;
}

RgbdImage SmallImage(Stamp stamp) {
  RgbdImage image;
  image.stamp = stamp;
  image.depth_stamp = {stamp.ns + 5'000'000};
  image.colour = cv::Mat(8, 8, CV_8UC3, cv::Scalar(200, 100, 50));
  image.depth_m = cv::Mat(8, 8, CV_32FC1, cv::Scalar(1.0));
  image.depth_m.row(0).colRange(0, 5) =
      (cv::Mat_<float>(1, 5) << 2.5f, kNaN, 13.1f, 13.2f, -1.0f) + 0.0f;
  return image;
}

TEST(TumFolderWriterTest, WhatIsWrittenReadsBack) {
  const TemporaryFolder folder;
  TumFolderWriter writer(folder / "new/sequence", SmallConfig());
  writer.Add(SmallImage(Stamp{1'000'000'000}));
  writer.Add(SmallImage(Stamp{1'033'333'000}));
  writer.WriteAccelerometer({{Stamp{1'000'000'000}, {0.5, -9.75, 0.25}}});
  writer.Finish();
  const CameraConfig camera = LoadCameraConfig(folder / "new/sequence/camera.yaml");
  EXPECT_TRUE(camera.intrinsics == SmallConfig().intrinsics);
  EXPECT_EQ(camera.R_camera_imu, SmallConfig().R_camera_imu);
  TumFolder source(folder / "new/sequence", camera);
  ASSERT_EQ(source.size(), 2u);
  const auto image = source.Next();
  ASSERT_TRUE(image);
  EXPECT_EQ(image->stamp.ns, 1'000'000'000);
  EXPECT_EQ(image->depth_stamp.ns, 1'005'000'000);
  EXPECT_FLOAT_EQ(image->depth_m.at<float>(0, 0), 2.5f);
  EXPECT_FLOAT_EQ(image->depth_m.at<float>(0, 2), 13.1f);
  // 6: what JPEG makes of one flat colour at this quality.
  EXPECT_LE(cv::norm(image->colour, SmallImage({}).colour, cv::NORM_INF), 6.0);
  ASSERT_EQ(source.accelerometer().size(), 1u);
  EXPECT_EQ(source.accelerometer()[0].acceleration_imu, Eigen::Vector3d(0.5, -9.75, 0.25));
}

TEST(TumFolderWriterTest, DepthThatSixteenBitsCannotHoldIsNone) {
  const TemporaryFolder folder;
  TumFolderWriter writer(folder.path(), SmallConfig());
  writer.Add(SmallImage(Stamp{1'000'000'000}));
  const cv::Mat png = cv::imread(folder / "depth/1.005000.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(png.type(), CV_16UC1);
  EXPECT_EQ(png.at<std::uint16_t>(0, 1), 0);      // NaN
  EXPECT_EQ(png.at<std::uint16_t>(0, 2), 65500);  // 13.1 m
  EXPECT_EQ(png.at<std::uint16_t>(0, 3), 0);      // 13.2 m, over 65535 / 5000
  EXPECT_EQ(png.at<std::uint16_t>(0, 4), 0);      // negative
}

TEST(TumFolderWriterTest, ImagesOfOtherKindsHaveListsOfTheirOwn) {
  const TemporaryFolder folder;
  const cv::Mat instances = (cv::Mat_<std::uint16_t>(1, 2) << 7, 1000);
  TumFolderWriter writer(folder.path(), SmallConfig());
  writer.Add("instances", Stamp{2'000'000'000}, instances);
  writer.Finish();
  ProblemLog problems;
  const auto files = ReadImageList(folder.path(), "instances.txt", problems);
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].stamp.ns, 2'000'000'000);
  const cv::Mat read = cv::imread(files[0].path, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.type(), CV_16UC1);
  EXPECT_EQ(cv::norm(read, instances, cv::NORM_INF), 0.0);
}

TEST(TumFolderWriterTest, IsASequenceOnlyOnceItIsFinished) {
  const TemporaryFolder folder;
  folder.Write("rgb.txt", "# of a sequence that was here before\n");
  TumFolderWriter writer(folder.path(), SmallConfig());
  writer.Add(SmallImage(Stamp{1'000'000'000}));
  EXPECT_FALSE(IsTumFolder(folder.path()));
  writer.Finish();
  EXPECT_TRUE(IsTumFolder(folder.path()));
}

TEST(TumFolderWriterTest, NamesWhatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("file", "");
  ExpectOneLineWith(
      MessageOf<InputError>([&] { TumFolderWriter writer(file + "/below", SmallConfig()); }),
      {"file/below"});
  TumFolderWriter writer(folder.path(), SmallConfig());
  folder.Write("labels", "no folder");
  ExpectOneLineWith(MessageOf<InputError>([&] {
                      writer.Add("labels", Stamp{1}, cv::Mat(2, 2, CV_8UC1, cv::Scalar(1)));
                    }),
                    {"labels/0.000000001.png"});
}

}  // namespace
}  // namespace semantic_slam
