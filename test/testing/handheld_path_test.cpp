#include "testing/handheld_path.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "testing/textured_room.h"

namespace semantic_slam {
namespace {

TEST(HandheldPathTest, IsARotationWithTheCameraUpright) {
  for (double t_s = 0.0; t_s < 40.0; t_s += 0.37) {
    const Rigid3d T = HandheldPath::T_world_camera(t_s);
    EXPECT_TRUE((T.linear() * T.linear().transpose()).isIdentity(1e-12));
    EXPECT_NEAR(T.linear().determinant(), 1.0, 1e-12);
    EXPECT_LT(T.linear()(2, 1), -0.8);  // the image's down is mostly the world's down
  }
}

TEST(HandheldPathTest, StaysInTheRoomAndMovesLikeAHand) {
  double fastest_m_per_s = 0.0, fastest_rad_per_s = 0.0;
  const double step_s = 1.0 / 30.0;
  for (double t_s = 0.0; t_s < 40.0; t_s += step_s) {
    const Rigid3d a = HandheldPath::T_world_camera(t_s);
    const Rigid3d b = HandheldPath::T_world_camera(t_s + step_s);
    EXPECT_LT(std::abs(a.translation().x()), 0.5 * TexturedRoom::kLengthM - 1.0);
    EXPECT_LT(std::abs(a.translation().y()), 0.5 * TexturedRoom::kWidthM - 1.0);
    fastest_m_per_s =
        std::max(fastest_m_per_s, (b.translation() - a.translation()).norm() / step_s);
    fastest_rad_per_s =
        std::max(fastest_rad_per_s, RotationAngle(a.linear().transpose() * b.linear()) / step_s);
  }
  EXPECT_GT(fastest_m_per_s, 0.2);
  EXPECT_LT(fastest_m_per_s, 0.7);
  EXPECT_LT(fastest_rad_per_s, 0.8);
}

TEST(HandheldPathTest, StartsAlmostAtRest) {
  const Rigid3d T = HandheldPath::T_world_camera(0.0).inverse() * HandheldPath::T_world_camera(0.1);
  EXPECT_LT(T.translation().norm(), 0.015);
}

TEST(HandheldPathTest, SpecificForceIsMostlyGravity) {
  const Rigid3d T_world_camera = HandheldPath::T_world_camera(5.0);
  const Eigen::Vector3d force_world = T_world_camera.linear() * HandheldPath::SpecificForce(5.0);
  EXPECT_NEAR(force_world.z(), 9.81, 1.0);
  EXPECT_LT(force_world.head<2>().norm(), 1.0);
}

}  // namespace
}  // namespace semantic_slam
