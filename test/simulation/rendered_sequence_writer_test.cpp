#include "semantic_slam/simulation/rendered_sequence_writer.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/accelerometer_file.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "testing/small_vocabulary.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

CameraConfig Camera() {
  CameraConfig config;
  config.intrinsics = {16, 8, 10.0, 10.0, 7.5, 3.5, {}};
  config.R_camera_imu = Eigen::Vector3d(-1.0, -1.0, 1.0).asDiagonal();
  return config;
}

SimulatedImage Image(Stamp stamp) {
  SimulatedImage image;
  image.measured.stamp = image.measured.depth_stamp = stamp;
  image.measured.colour = cv::Mat(8, 16, CV_8UC3, cv::Scalar(10, 20, 30));
  image.measured.depth_m = cv::Mat(8, 16, CV_32FC1, cv::Scalar(1.5));
  image.truth.labels = cv::Mat(8, 16, CV_8UC1, cv::Scalar(4));
  image.truth.instances = cv::Mat(8, 16, CV_16UC1, cv::Scalar(300));
  return image;
}

VisibleObjects Objects(Stamp stamp) {
  VisibleObjects objects;
  objects.detections.stamp = stamp;
  objects.detections.image_size = {16, 8};
  objects.detections.boxes = {{4, 1.0f, {-0.5f, -0.5f, 8.0f, 8.0f}}};  // the left half
  objects.instances = {300};
  objects.visible_shares = {0.75f};
  return objects;
}

// Two chairs that look alike, and a table.
World Twins() {
  World world;
  for (const LabelId label : {3, 3, 4}) {
    world.objects.emplace_back();
    world.objects.back().instance = static_cast<InstanceId>(world.objects.size());
    world.objects.back().label = label;
  }
  return world;
}

CameraPath Path() {
  CameraPath path;
  for (const std::int64_t s : {1, 2, 3}) {
    path.T_world_camera.push_back({Stamp{s * 1'000'000'000}, Rigid3d::Identity()});
  }
  path.readings = {{Stamp{1'500'000'000}, {0.1, 0.2, 0.3}, {1.0, -9.0, 2.0}}};
  return path;
}

std::string TextOf(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void Write(const std::string& folder, int truth_period) {
  RenderedSequenceWriter writer(folder, Camera(), SmallVocabulary(), Twins(), truth_period);
  for (const StampedPose& stamped : Path().T_world_camera) {
    writer.Add(Image(stamped.stamp), Objects(stamped.stamp));
  }
  writer.Finish(Path());
}

TEST(RenderedSequenceWriterTest, IsATumFolder) {
  const TemporaryFolder folder;
  Write(folder.path(), 1);
  TumFolder source(folder.path(), LoadCameraConfig(folder / "camera.yaml"));
  EXPECT_EQ(source.size(), 3u);
  ASSERT_TRUE(source.Next());
  EXPECT_EQ(ReadTumTrajectory(folder / "groundtruth.txt").size(), 3u);
}

TEST(RenderedSequenceWriterTest, HasTheTruthOfEveryImage) {
  const TemporaryFolder folder;
  Write(folder.path(), 1);
  const cv::Mat labels = cv::imread(folder / "labels/2.000000.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(labels.type(), CV_8UC1);
  EXPECT_EQ(labels.at<std::uint8_t>(3, 3), 4);
  const cv::Mat instances = cv::imread(folder / "instances/2.000000.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(instances.type(), CV_16UC1);
  EXPECT_EQ(instances.at<std::uint16_t>(3, 3), 300);
  EXPECT_EQ(TextOf(folder / "boxes/2.000000.txt"),
            "4 0.250000 0.500000 0.500000 1.000000 0.750000\n");
}

TEST(RenderedSequenceWriterTest, TellsWhichObjectsLookAlike) {
  const TemporaryFolder folder;
  Write(folder.path(), 1);
  EXPECT_EQ(TextOf(folder / "looks.txt"), "# instance look\n1 1\n2 1\n3 2\n");
}

TEST(RenderedSequenceWriterTest, ClassesAreNamedByLine) {
  const TemporaryFolder folder;
  Write(folder.path(), 1);
  EXPECT_EQ(TextOf(folder / "classes.txt"),
            "unknown\nwall\nfloor\nchair\ntable\n-\n-\n-\n-\nlamp\n");
}

TEST(RenderedSequenceWriterTest, TheImuHasItsOwnAxes) {
  const TemporaryFolder folder;
  Write(folder.path(), 1);
  EXPECT_EQ(TextOf(folder / "imu.txt"),
            "# timestamp wx wy wz ax ay az\n"
            "1.500000 -0.100000 -0.200000 0.300000 -1.000000 9.000000 2.000000\n");
  const auto readings = ReadAccelerometerFile(folder / "accelerometer.txt");
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].acceleration_imu, Eigen::Vector3d(-1.0, 9.0, 2.0));
}

TEST(RenderedSequenceWriterTest, MayLeaveTruthOut) {
  const TemporaryFolder folder;
  Write(folder.path(), 2);
  EXPECT_TRUE(std::filesystem::exists(folder / "labels/1.000000.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "labels/2.000000.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "boxes/2.000000.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder / "labels/3.000000.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "rgb/2.000000.jpg"));
}

TEST(RenderedSequenceWriterTest, NamesAFolderThatCannotBeMade) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("file", "");
  EXPECT_THROW(RenderedSequenceWriter(file + "/below", Camera(), SmallVocabulary(), Twins()),
               InputError);
}

}  // namespace
}  // namespace semantic_slam
