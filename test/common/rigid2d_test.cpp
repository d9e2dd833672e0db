#include "semantic_slam/common/rigid2d.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kRounding = 1e-12;

TEST(Rigid2dTest, ComposesAsPosesInThePlane) {
  const Rigid2d T_a_b = MakeRigid2d({1.0, 2.0}, M_PI / 2);
  const Rigid2d T_b_c = MakeRigid2d({3.0, 0.0}, M_PI / 4);
  const Rigid2d T_a_c = T_a_b * T_b_c;
  EXPECT_TRUE(T_a_c.translation().isApprox(Eigen::Vector2d(1.0, 5.0), kRounding));
  EXPECT_NEAR(Yaw(T_a_c), 3 * M_PI / 4, kRounding);
}

TEST(Rigid2dTest, FlattensAPoseInSpace) {
  Rigid3d T = Rigid3d::Identity();
  T.translation() << 1.0, 2.0, 3.0;
  T.linear() = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY()))
                   .toRotationMatrix();
  const Rigid2d flat = Flattened(T);
  EXPECT_EQ(flat.translation(), Eigen::Vector2d(1.0, 2.0));
  EXPECT_NEAR(Yaw(flat), 0.7, kRounding) << "tilt about the pose's own y axis is not yaw";
}

TEST(Rigid2dTest, ComesBackFromSpace) {
  const Rigid2d T = MakeRigid2d({1.0, -2.0}, 2.5);
  const Rigid3d T_space = InSpace(T);
  EXPECT_EQ(T_space.translation().z(), 0.0);
  EXPECT_TRUE(T_space.linear().col(2).isApprox(Eigen::Vector3d::UnitZ(), kRounding));
  EXPECT_TRUE(Flattened(T_space).isApprox(T, kRounding));
}

}  // namespace
}  // namespace semantic_slam
