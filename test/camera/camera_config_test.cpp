#include "semantic_slam/camera/camera_config.h"

#include <string>

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr char kCamera[] =
    "camera: {width_px: 640, height_px: 480, fx_px: 500, fy_px: 501, cx_px: 320, cy_px: 240}\n";

class CameraConfigTest : public testing::Test {
 protected:
  CameraConfig Load(const std::string& yaml) {
    return LoadCameraConfig(folder_.Write("camera.yaml", yaml));
  }
  void ExpectError(const std::string& yaml, std::initializer_list<const char*> parts) {
    const std::string message = MessageOf<ConfigError>([&] { Load(yaml); });
    ExpectOneLineWith(message, parts);
    ExpectOneLineWith(message, {"camera.yaml"});
  }

  TemporaryFolder folder_;
};

TEST_F(CameraConfigTest, OnlyTheCameraMustBeGiven) {
  const CameraConfig config = Load(kCamera);
  EXPECT_EQ(config.intrinsics.width_px, 640);
  EXPECT_EQ(config.intrinsics.fy_px, 501.0);
  EXPECT_TRUE(config.intrinsics.distortion.empty());
  EXPECT_TRUE(config.R_camera_imu.isIdentity());
  EXPECT_EQ(config.depth_png_factor, 5000.0);
}

TEST_F(CameraConfigTest, TheRotationIsGivenByRows) {
  const CameraConfig config =
      Load(std::string(kCamera) + "imu: {R_camera_imu: [0, -1, 0, 1, 0, 0, 0, 0, 1]}\n");
  EXPECT_TRUE((config.R_camera_imu * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d::UnitY()));
}

TEST_F(CameraConfigTest, AShutterIsGlobalUnlessItIsSaidToRoll) {
  EXPECT_EQ(Load(kCamera).intrinsics.readout_s, 0.0);
  std::string rolling = kCamera;
  rolling.insert(rolling.find('}'), ", readout_s: 0.02");
  EXPECT_EQ(Load(rolling).intrinsics.readout_s, 0.02);
  rolling.replace(rolling.find("0.02"), 4, "2.00");
  ExpectError(rolling, {"readout_s = 2"});
}

TEST_F(CameraConfigTest, LeavesOtherGroupsToOtherReaders) {
  EXPECT_NO_THROW(Load(std::string(kCamera) + "tracking: {max_features: 1000}\n"));
}

TEST_F(CameraConfigTest, NamesWhatIsMissingUnknownOrOfAnotherType) {
  ExpectError("imu: {}\n", {"missing key camera/width_px"});
  ExpectError(std::string(kCamera) + "dataset: {depth_factor: 1000}\n",
              {"camera.yaml:2: unknown key dataset/depth_factor"});
  ExpectError("camera: {width_px: wide}\n", {"camera/width_px = wide has the wrong type"});
  ExpectError(std::string(kCamera) + "imu: [1]\n", {"imu must be a mapping"});
}

TEST_F(CameraConfigTest, NamesWhatIsOutOfRange) {
  ExpectError(std::string(kCamera) + "dataset: {depth_png_factor: 0}\n",
              {"dataset/depth_png_factor = 0"});
  ExpectError(
      "camera: {width_px: 640, height_px: 480, fx_px: 0, fy_px: 5, cx_px: 320, cy_px: 240}\n",
      {"fx_px = 0"});
  ExpectError(std::string(kCamera) + "imu: {R_camera_imu: [1, 0, 0]}\n",
              {"imu/R_camera_imu has 3 numbers, expected 9"});
  ExpectError(std::string(kCamera) + "imu: {R_camera_imu: [1, 0, 0, 0, 1, 0, 0, 0, -1]}\n",
              {"imu/R_camera_imu is not a rotation"});
}

TEST_F(CameraConfigTest, NamesAMissingFile) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { LoadCameraConfig("/nowhere/camera.yaml"); }),
                    {"/nowhere/camera.yaml"});
}

class ShippedCameraTest : public testing::TestWithParam<const char*> {};

TEST_P(ShippedCameraTest, Loads) {
  const std::string path = std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/" + GetParam();
  const CameraConfig config = LoadCameraConfig(path);
  EXPECT_NO_THROW(CheckIntrinsics(config.intrinsics));
  EXPECT_EQ(config.intrinsics.width_px, 640);
}

INSTANTIATE_TEST_SUITE_P(Config, ShippedCameraTest,
                         testing::Values("tum_freiburg1.yaml", "tum_freiburg2.yaml",
                                         "tum_freiburg3.yaml", "d455.yaml"));

}  // namespace
}  // namespace semantic_slam
