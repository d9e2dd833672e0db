#include "semantic_slam/common/interpolation.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Rigid3d Pose(double x_m, double yaw_rad) {
  return Eigen::Translation3d(x_m, 0.0, 0.0) *
         Rigid3d(Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()));
}

TEST(InterpolationTest, GoesFromOnePoseToTheOther) {
  const Rigid3d a = Pose(1.0, 0.2), b = Pose(3.0, 1.2);
  EXPECT_TRUE(Interpolated(a, b, 0.0).isApprox(a, 1e-12));
  EXPECT_TRUE(Interpolated(a, b, 0.25).isApprox(Pose(1.5, 0.45), 1e-12));
  EXPECT_TRUE(Interpolated(a, b, 1.0).isApprox(b, 1e-12));
}

TEST(InterpolationTest, TurnsTheShorterWay) {
  EXPECT_TRUE(Interpolated(Pose(0.0, 3.0), Pose(0.0, -3.0), 0.5).isApprox(Pose(0.0, M_PI), 1e-9));
}

}  // namespace
}  // namespace semantic_slam
