#include "semantic_slam/camera/level_frame.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kRounding = 1e-12;

// A camera at (1, 2, 3) that looks along x of the map, then turned in its own axes: by `yaw` to the
// left, by `pitch` down, by `roll` clockwise.
Rigid3d Camera(double yaw_rad, double pitch_rad, double roll_rad) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  Rigid3d T = Rigid3d::Identity();
  T.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  T.linear() = AngleAxisd(yaw_rad, Vector3d::UnitZ()) * T.linear() *
               AngleAxisd(-pitch_rad, Vector3d::UnitX()) * AngleAxisd(roll_rad, Vector3d::UnitZ());
  T.translation() << 1.0, 2.0, 3.0;
  return T;
}

TEST(LevelFrameTest, KeepsYawAndPlaceAndNothingElse) {
  for (const double pitch_rad : {-1.2, 0.0, 0.7}) {
    for (const double roll_rad : {-2.0, 0.0, 0.4}) {
      const Rigid3d T_map_level = LevelPose(Camera(0.5, pitch_rad, roll_rad));
      const Eigen::AngleAxisd yaw(0.5, Eigen::Vector3d::UnitZ());
      EXPECT_TRUE(T_map_level.linear().isApprox(yaw.toRotationMatrix(), kRounding));
      EXPECT_EQ(T_map_level.translation(), Eigen::Vector3d(1.0, 2.0, 3.0));
    }
  }
}

TEST(LevelFrameTest, FollowsTheUpperEdgeOfAVerticalView) {
  for (const double pitch_rad : {-M_PI / 2, M_PI / 2}) {
    const Rigid3d T_map_camera = Camera(0.5, pitch_rad, 0.0);
    const Rigid3d T_map_level = LevelPose(T_map_camera);
    EXPECT_TRUE(T_map_level.linear().col(0).isApprox(-T_map_camera.linear().col(1), kRounding));
    EXPECT_NEAR(T_map_level.linear()(2, 2), 1.0, kRounding);
  }
}

TEST(LevelFrameTest, IsTheOrientationOfTheLevelPose) {
  const Rigid3d T_map_camera = Camera(-0.3, 0.4, 0.2);
  const Eigen::Vector3d up_camera = T_map_camera.linear().row(2);
  const Eigen::Matrix3d R_map_camera =
      LevelPose(T_map_camera).linear() * LevelFromCamera(up_camera);
  EXPECT_TRUE(R_map_camera.isApprox(T_map_camera.linear(), kRounding));
}

}  // namespace
}  // namespace semantic_slam
