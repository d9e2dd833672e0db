#include "semantic_slam/localization/gravity_alignment.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Stamp kNow{1'000'000'000'000};

// Readings of 9.81 m/s^2 along y every 10 ms from `first_s` to `last_s` after kNow.
std::vector<AccelerometerReading> AtRest(double first_s, double last_s) {
  std::vector<AccelerometerReading> readings;
  for (double t_s = first_s; t_s < last_s + 1e-6; t_s += 0.01) {
    readings.push_back({{kNow.ns + static_cast<std::int64_t>(std::llround(t_s * 1e9))},
                        Eigen::Vector3d(0.0, 9.81, 0.0)});
  }
  return readings;
}

void ExpectRotation(const Rigid3d& T) {
  EXPECT_NEAR((T.linear() * T.linear().transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0,
              1e-12);
  EXPECT_NEAR(T.linear().determinant(), 1.0, 1e-12);
}

TEST(StartPoseFromUpTest, ALevelCameraLooksAlongX) {
  const Rigid3d T_map_camera = StartPoseFromUp({0.0, -9.81, 0.0});  // the image's y points down
  Eigen::Matrix3d R_map_camera;  // x right is -y, y down is -z, z forward is x
  R_map_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  EXPECT_TRUE(T_map_camera.linear().isApprox(R_map_camera, 1e-12));
  EXPECT_EQ(T_map_camera.translation(), Eigen::Vector3d::Zero());
}

TEST(StartPoseFromUpTest, ATiltedCameraLooksAsFarDownAsItIsTilted) {
  // 30 degrees down: "up" is above the image and a bit behind the camera.
  const double tilt_rad = M_PI / 6.0;
  const Rigid3d T_map_camera = StartPoseFromUp({0.0, -std::cos(tilt_rad), -std::sin(tilt_rad)});
  ExpectRotation(T_map_camera);
  const Eigen::Vector3d view = T_map_camera.linear().col(2);
  EXPECT_TRUE(view.isApprox(Eigen::Vector3d(std::cos(tilt_rad), 0.0, -std::sin(tilt_rad)), 1e-12));
}

TEST(StartPoseFromUpTest, UpIsUpHoweverTheCameraIsHeld) {
  for (double roll_rad = 0.0; roll_rad < 6.2; roll_rad += 0.5) {
    for (double tilt_rad = -1.5; tilt_rad <= 1.5; tilt_rad += 0.5) {
      const Eigen::Vector3d up_camera =
          Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()) *
          Eigen::Vector3d(0.0, -std::cos(tilt_rad), -std::sin(tilt_rad));
      const Rigid3d T_map_camera = StartPoseFromUp(3.0 * up_camera);
      ExpectRotation(T_map_camera);
      EXPECT_TRUE((T_map_camera.linear() * up_camera).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
      EXPECT_NEAR(T_map_camera.linear().col(2).y(), 0.0, 1e-12);  // looks along x, up or down
      EXPECT_GT(T_map_camera.linear().col(2).x(), 0.0);
    }
  }
}

TEST(StartPoseFromUpTest, ACameraLookingStraightDownHasXAtTheImagesUpperEdge) {
  const Rigid3d T_map_camera = StartPoseFromUp({0.0, 0.0, -9.81});
  ExpectRotation(T_map_camera);
  EXPECT_TRUE(T_map_camera.linear().col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_TRUE((T_map_camera.linear() * -Eigen::Vector3d::UnitY())
                  .isApprox(Eigen::Vector3d::UnitX(), 1e-12));
}

TEST(StartPoseFromUpTest, ACameraLookingNearlyStraightUpOrDownIsFineToo) {
  for (const double offset : {0.0, 1e-12, 1e-6, 1e-3, 2e-3}) {
    for (const double z : {-1.0, 1.0}) {
      const Eigen::Vector3d up_camera = Eigen::Vector3d(offset, offset, z).normalized();
      const Rigid3d T_map_camera = StartPoseFromUp(up_camera);
      ExpectRotation(T_map_camera);
      EXPECT_TRUE((T_map_camera.linear() * up_camera).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
    }
  }
}

TEST(StartPoseFromUpTest, RefusesWhatIsNoDirection) {
  for (const Eigen::Vector3d& none :
       {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, kNan, 1.0)}) {
    EXPECT_EQ(MessageOf<InputError>([&] { StartPoseFromUp(none); }),
              "the direction of gravity is not finite or has length zero");
  }
}

TEST(MeanAccelerationTest, IsTheMeanOfTheReadingsAround) {
  auto readings = AtRest(-0.2, 0.2);
  for (std::size_t i = 0; i < readings.size(); ++i) {  // a hand shakes
    readings[i].acceleration_imu.x() = i % 2 == 0 ? 1.0 : -1.0;
  }
  const auto mean = MeanAcceleration(readings, kNow);
  ASSERT_TRUE(mean);
  // 41 readings: one +1 is left over.
  EXPECT_TRUE(mean->isApprox(Eigen::Vector3d(1.0 / 41.0, 9.81, 0.0), 1e-9));
}

TEST(MeanAccelerationTest, OnlyReadingsInTheWindowCount) {
  auto readings = AtRest(-2.0, 2.0);
  for (AccelerometerReading& reading : readings) {
    if (std::abs(SecondsBetween(kNow, reading.stamp)) > 0.51) reading.acceleration_imu.x() = 5.0;
  }
  const auto mean = MeanAcceleration(readings, kNow);
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->x(), 0.0, 1e-12);
  EXPECT_FALSE(MeanAcceleration(readings, kNow, 0.005));  // one reading is too few
  EXPECT_FALSE(MeanAcceleration(AtRest(0.6, 2.0), kNow));
  EXPECT_FALSE(MeanAcceleration({}, kNow));
}

TEST(MeanAccelerationTest, ThreeReadingsAreEnough) {
  EXPECT_FALSE(MeanAcceleration(AtRest(0.0, 0.01), kNow));
  EXPECT_TRUE(MeanAcceleration(AtRest(0.0, 0.02), kNow));
}

TEST(MeanAccelerationTest, WhatIsNotAsLongAsGravityIsNotGravity) {
  for (const auto& [length, is_gravity] :
       {std::pair(7.8, false), {7.9, true}, {9.81, true}, {11.7, true}, {11.8, false}}) {
    auto readings = AtRest(-0.1, 0.1);
    for (auto& reading : readings) reading.acceleration_imu = Eigen::Vector3d(0.0, 0.0, length);
    EXPECT_EQ(MeanAcceleration(readings, kNow).has_value(), is_gravity) << length;
  }
}

TEST(MeanAccelerationTest, ReadingsThatAreNoNumbersDoNotCount) {
  auto readings = AtRest(-0.1, 0.1);
  readings[3].acceleration_imu.x() = kNan;
  const auto mean = MeanAcceleration(readings, kNow);
  ASSERT_TRUE(mean);
  EXPECT_TRUE(mean->isApprox(Eigen::Vector3d(0.0, 9.81, 0.0), 1e-9));
}

TEST(FindMapStartTest, TheAccelerometerGoesFirstAndThenALevelBase) {
  const RgbdImage blank = BlankImage(kNow);  // a wall, and no floor
  Rigid3d T_base_camera = Rigid3d::Identity();
  T_base_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const auto by_imu =
      FindMapStart(Eigen::Vector3d(9.81, 0.0, 0.0), blank, *SmallCamera(), T_base_camera);
  EXPECT_EQ(by_imu.source, "up from the imu");
  // A camera on its side: its x axis is up.
  EXPECT_TRUE(by_imu.T_map_camera.linear().col(0).isApprox(Eigen::Vector3d::UnitZ(), 1e-12));
  const auto level = FindMapStart(std::nullopt, blank, *SmallCamera(), T_base_camera);
  EXPECT_EQ(level.source, "the base is taken to stand level");
  EXPECT_EQ(level.T_map_camera.matrix(), T_base_camera.matrix());
}

TEST(FindMapStartTest, RefusesAnImageOfAnotherCamera) {
  CameraIntrinsics smaller = SmallIntrinsics();
  smaller.width_px /= 2;
  smaller.height_px /= 2;
  const RgbdImage image = BlankImage(kNow);
  EXPECT_THROW(FindMapStart(std::nullopt, image, CameraModel(smaller), Rigid3d::Identity()),
               InputError);
}

}  // namespace
}  // namespace semantic_slam
