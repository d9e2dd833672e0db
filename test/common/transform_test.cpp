#include "semantic_slam/common/transform.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

Rigid3d PlanarPose(double x_m, double y_m, double yaw_rad) {
  return Eigen::Translation3d(x_m, y_m, 0.0) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

TEST(TransformTest, NeighbouringNamesCancel) {
  const Rigid3d T_map_base = PlanarPose(1.0, 0.0, M_PI / 2);  // faces map's +y
  const Eigen::Vector3d p_map = T_map_base * Eigen::Vector3d(2.0, 0.0, 0.0);
  EXPECT_TRUE(p_map.isApprox(Eigen::Vector3d(1.0, 2.0, 0.0), 1e-12));
}

TEST(TransformTest, MapFromOdomCarriesTheRobotBackToItsMapPose) {
  const Rigid3d T_map_base = PlanarPose(2.0, 1.0, 0.5);
  const Rigid3d T_odom_base = PlanarPose(1.8, 1.1, 0.4);  // odometry has drifted
  const Rigid3d T_map_odom = MapFromOdom(T_map_base, T_odom_base);
  EXPECT_TRUE((T_map_odom * T_odom_base).isApprox(T_map_base, 1e-12));
}

TEST(TransformTest, SkewIsTheCrossProduct) {
  const Eigen::Vector3d v(1.0, -2.0, 3.0), w(0.5, 4.0, -1.0);
  EXPECT_TRUE((Skew(v) * w).isApprox(v.cross(w)));
}

// Angles around everything that needs a case of its own: zero, tiny, a right angle, nearly pi.
const std::vector<double> kAngles{0.0, 1e-12, 1e-9, 1e-7, 1e-4, 0.3, M_PI / 2, M_PI - 1e-6};

TEST(TransformTest, ExpSo3TurnsByTheAngleAboutTheAxis) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, -0.5).normalized();
  for (const double angle : kAngles) {
    const Eigen::Matrix3d R = ExpSo3(angle * axis);
    EXPECT_TRUE(R.isApprox(Eigen::AngleAxisd(angle, axis).toRotationMatrix(), 1e-14)) << angle;
    EXPECT_NEAR((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 0.0, 1e-14) << angle;
  }
}

TEST(TransformTest, RotationAngleUndoesExpSo3) {
  const Eigen::Vector3d axis = Eigen::Vector3d(-1.0, 0.2, 0.7).normalized();
  for (const double angle : kAngles) {
    EXPECT_NEAR(RotationAngle(ExpSo3(angle * axis)), angle, 1e-7) << angle;
    EXPECT_NEAR(RotationAngle(ExpSo3(-angle * axis)), angle, 1e-7) << angle;
  }
}

TEST(TransformTest, OrthonormalisedRemovesTheDriftOfManyProducts) {
  Rigid3d T = PlanarPose(1.0, 2.0, 0.3);
  T.linear() *= 1.0 + 1e-6;  // as after very many products
  const Rigid3d clean = Orthonormalised(T);
  EXPECT_NEAR((clean.linear() * clean.linear().transpose()).trace(), 3.0, 1e-12);
  EXPECT_TRUE(clean.isApprox(PlanarPose(1.0, 2.0, 0.3), 1e-12));
}

TEST(TransformTest, IsFiniteNoticesASingleBadNumber) {
  Rigid3d T = PlanarPose(1.0, 2.0, 0.3);
  EXPECT_TRUE(IsFinite(T));
  T.translation().y() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(IsFinite(T));
  T = Rigid3d::Identity();
  T.linear()(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(IsFinite(T));
}

}  // namespace
}  // namespace semantic_slam
