#include "semantic_slam/simulation/simulated_camera.h"

#include <cstring>

#include <gtest/gtest.h>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/error.h"
#include "simulation/world_builder.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

bool SameBytes(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && std::memcmp(a.data, b.data, a.total() * a.elemSize()) == 0;
}

std::shared_ptr<const SceneRenderer> Room() {
  WorldBuilder builder;
  builder.AddRoom(1, {-2, -2, 0}, {2, 2, 2.5f});
  builder.AddLight({0, 0, 2.4});
  return std::make_shared<SceneRenderer>(builder.Build());
}

const Rigid3d kPose = LookAt({-1.5, 0.1, 1.2}, {2, 0, 1});

TEST(SimulatedCameraTest, DeliversWhatThePipelineTakes) {
  const SimulatedCamera camera(Room(), SmallCamera().intrinsics());
  const SimulatedImage image = camera.Capture(kPose, Stamp{123}, 0.0);
  EXPECT_NO_THROW(CheckRgbdImage(image.measured, camera.model()));
  EXPECT_EQ(image.measured.stamp, Stamp{123});
  EXPECT_EQ(image.measured.depth_stamp, Stamp{123});
  EXPECT_EQ(image.measured.order, ColourOrder::kBgr);
  EXPECT_FALSE(SameBytes(image.measured.colour, image.truth.colour));
  EXPECT_FALSE(SameBytes(image.measured.depth_m, image.truth.depth_m));
}

TEST(SimulatedCameraTest, WithoutNoiseItDeliversTheTruth) {
  SimulatedCameraOptions options;
  options.depth_noise.noise = options.colour_noise.noise = false;
  const SimulatedCamera camera(Room(), SmallCamera().intrinsics(), options);
  const SimulatedImage image = camera.Capture(kPose, Stamp{123}, 0.0);
  EXPECT_TRUE(SameBytes(image.measured.colour, image.truth.colour));
  EXPECT_TRUE(SameBytes(image.measured.depth_m, image.truth.depth_m));
}

TEST(SimulatedCameraTest, TheSameSeedGivesTheSameBytes) {
  const SimulatedImage a =
      SimulatedCamera(Room(), SmallCamera().intrinsics()).Capture(kPose, Stamp{123}, 0.0);
  const SimulatedImage b =
      SimulatedCamera(Room(), SmallCamera().intrinsics()).Capture(kPose, Stamp{123}, 0.0);
  EXPECT_TRUE(SameBytes(a.measured.colour, b.measured.colour));
  EXPECT_TRUE(SameBytes(a.measured.depth_m, b.measured.depth_m));
}

TEST(SimulatedCameraTest, RefusesOptionsAndIntrinsicsOutOfRange) {
  SimulatedCameraOptions options;
  options.depth_noise.baseline_m = -1.0;
  EXPECT_NE(MessageOf<ConfigError>([&] {
              SimulatedCamera(Room(), SmallCamera().intrinsics(), options);
            }).find("depth_noise/baseline_m"),
            std::string::npos);
  EXPECT_FALSE(
      MessageOf<ConfigError>([&] { SimulatedCamera(Room(), CameraIntrinsics()); }).empty());
}

class SimulatedD455 : public testing::TestWithParam<std::pair<const char*, cv::Size>> {};

TEST_P(SimulatedD455, IsConfigured) {
  const auto& [name, size] = GetParam();
  const CameraConfig config =
      LoadCameraConfig(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/" + name);
  EXPECT_EQ(config.intrinsics.width_px, size.width);
  EXPECT_EQ(config.intrinsics.height_px, size.height);
  EXPECT_EQ(config.depth_png_factor, 5000.0);
  EXPECT_NO_THROW(SimulatedCamera(Room(), config.intrinsics));
}

INSTANTIATE_TEST_SUITE_P(SimulatedCameraTest, SimulatedD455,
                         testing::Values(std::pair("simulated_d455.yaml", cv::Size(640, 480)),
                                         std::pair("simulated_d455_1280x720.yaml",
                                                   cv::Size(1280, 720))));

}  // namespace
}  // namespace semantic_slam
