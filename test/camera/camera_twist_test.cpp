#include "semantic_slam/camera/camera_twist.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(CameraTwistTest, MovesAlongItsOwnAxes) {
  const CameraTwist twist{{1.0, 2.0, 3.0}, {0.0, 0.0, 0.5}};
  const Rigid3d T = twist.T_now_then(0.1);
  EXPECT_TRUE(T.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
  EXPECT_TRUE(T.linear().isApprox(ExpSo3(Eigen::Vector3d(0.0, 0.0, 0.05))));
}

TEST(CameraTwistTest, AtRestNothingMoves) {
  EXPECT_TRUE(CameraTwist().T_now_then(1.0).isApprox(Rigid3d::Identity()));
}

}  // namespace
}  // namespace semantic_slam
