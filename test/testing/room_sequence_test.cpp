#include "testing/room_sequence.h"

#include <cmath>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/dataset/tum_folder.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr double kSeconds = 0.2;  // six images

TEST(RoomSequenceTest, TheWrittenFolderReadsBack) {
  const TemporaryFolder folder;
  WriteRoomSequence(folder.path(), kSeconds);
  const CameraConfig camera = LoadCameraConfig(folder / "camera.yaml");
  TumFolder source(folder.path(), camera);
  const auto rendered = MakeRoomSequence(kSeconds);
  ASSERT_EQ(source.size(), 6u);
  const auto poses = ReadTumTrajectory(folder / "groundtruth.txt");
  ASSERT_EQ(poses.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto read = source.Next(), expected = rendered->Next();
    ASSERT_TRUE(read && expected);
    EXPECT_EQ(read->stamp, expected->stamp);
    EXPECT_EQ(read->depth_stamp, expected->depth_stamp);
    EXPECT_EQ(read->stamp, poses[i].stamp);
    const float a = read->depth_m.at<float>(200, 300), b = expected->depth_m.at<float>(200, 300);
    EXPECT_NEAR(a, b, 0.5 / camera.depth_png_factor + 1e-6);  // half a unit of the PNG
    EXPECT_EQ(std::isnan(read->depth_m.at<float>(0, 0)),
              std::isnan(expected->depth_m.at<float>(0, 0)));
    EXPECT_LT(cv::norm(read->colour, expected->colour, cv::NORM_L1) / (3.0 * 640 * 480), 3.0);
  }
  EXPECT_FALSE(source.Next());
  EXPECT_EQ(source.dropped(), 0u);
  EXPECT_EQ(source.accelerometer().size(), 20u);
}

TEST(RoomSequenceTest, AtTheStartTheAccelerometerPointsUp) {
  const auto source = MakeRoomSequence(kSeconds);
  const Eigen::Vector3d force_camera =
      Freiburg1Camera().R_camera_imu * source->accelerometer().front().acceleration_imu;
  const Rigid3d T_world_camera = RoomSequencePoses(kSeconds).front().pose;
  EXPECT_GT((T_world_camera.linear() * force_camera).normalized().z(), 0.99);
}

TEST(RoomSequenceTest, ItsCameraIsTheShippedConfiguration) {
  const CameraConfig shipped =
      LoadCameraConfig(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/tum_freiburg1.yaml");
  EXPECT_TRUE(shipped.intrinsics == Freiburg1Camera().intrinsics);
  EXPECT_EQ(shipped.R_camera_imu, Freiburg1Camera().R_camera_imu);
  EXPECT_EQ(shipped.depth_png_factor, Freiburg1Camera().depth_png_factor);
}

TEST(RoomSequenceTest, NamesAFolderThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.Write("file", "");
  EXPECT_THROW(WriteRoomSequence(file + "/below", kSeconds), InputError);
}

}  // namespace
}  // namespace semantic_slam
