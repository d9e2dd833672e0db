#include "semantic_slam_ros/transform_tree.h"

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::Rigid3d;
using semantic_slam::Stamp;

Rigid3d At(double x_m, double yaw_rad = 0.0) {
  return Eigen::Translation3d(x_m, 0.0, 0.0) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ());
}

Stamp Seconds(std::int64_t s) {
  return {s * 1'000'000'000};
}

// world -> rig moves by 1 m/s from 0 to 4 s; rig -> camera and rig -> imu stand, told every 2 s.
TransformTree Recording() {
  TransformTree tree;
  for (int s = 0; s <= 4; ++s) tree.Add("world", "rig", Seconds(s), At(s, 0.1 * s));
  for (int s = 0; s <= 4; s += 2) {
    tree.Add("rig", "camera", Seconds(s), At(0.5, M_PI / 2));
    tree.Add("rig", "imu", Seconds(s), At(-0.5));
  }
  return tree;
}

TEST(TransformTreeTest, ThePathHasAPosePerStampOfTheMovingLink) {
  const auto path = Recording().Path("world", "camera");
  ASSERT_EQ(path.size(), 5u);
  EXPECT_EQ(path[3].stamp, Seconds(3));
  EXPECT_TRUE(path[3].pose.isApprox(At(3.0, 0.3) * At(0.5, M_PI / 2), 1e-12));
}

TEST(TransformTreeTest, InterpolatesTheSlowerOfTwoMovingLinks) {
  TransformTree tree = Recording();
  tree.Add("camera", "lens", Seconds(1), At(0.0));
  tree.Add("camera", "lens", Seconds(3), At(0.2, 0.4));
  const auto path = tree.Path("rig", "lens");  // the lens alone moves
  EXPECT_EQ(path.size(), 2u);
  const auto in_world = tree.Path("world", "lens");
  ASSERT_EQ(in_world.size(), 3u);  // at 1, 2 and 3 s: the lens is not known outside
  EXPECT_TRUE(in_world[1].pose.isApprox(At(2.0, 0.2) * At(0.5, M_PI / 2) * At(0.1, 0.2), 1e-12));
}

TEST(TransformTreeTest, NoPathWithoutAChainOrMotion) {
  const TransformTree tree = Recording();
  EXPECT_TRUE(tree.Path("world", "nowhere").empty());
  EXPECT_TRUE(tree.Path("nowhere", "camera").empty());
  EXPECT_TRUE(tree.Path("rig", "camera").empty());
  EXPECT_TRUE(TransformTree().Path("world", "camera").empty());
}

TEST(TransformTreeTest, FixedGoesUpAndDown) {
  const auto T_camera_imu = Recording().Fixed("camera", "imu");
  ASSERT_TRUE(T_camera_imu);
  EXPECT_TRUE(T_camera_imu->isApprox(At(0.5, M_PI / 2).inverse() * At(-0.5), 1e-12));
  EXPECT_TRUE(Recording().Fixed("camera", "rig")->isApprox(At(0.5, M_PI / 2).inverse(), 1e-12));
  EXPECT_TRUE(Recording().Fixed("rig", "camera")->isApprox(At(0.5, M_PI / 2), 1e-12));
  EXPECT_TRUE(Recording().Fixed("lonely", "lonely")->isApprox(Rigid3d::Identity()));
}

TEST(TransformTreeTest, NothingIsFixedAcrossAMovingLink) {
  EXPECT_FALSE(Recording().Fixed("world", "camera"));
  EXPECT_FALSE(Recording().Fixed("camera", "world"));
  EXPECT_FALSE(Recording().Fixed("camera", "nowhere"));
}

TEST(TransformTreeTest, SurvivesARing) {
  TransformTree tree;
  tree.Add("a", "b", Seconds(0), At(1.0));
  tree.Add("b", "a", Seconds(0), At(1.0));
  tree.Add("c", "c", Seconds(0), At(1.0));
  EXPECT_TRUE(tree.Path("world", "a").empty());
  EXPECT_FALSE(tree.Fixed("world", "a"));
  EXPECT_FALSE(tree.Fixed("a", "c"));
}

}  // namespace
}  // namespace semantic_slam_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
