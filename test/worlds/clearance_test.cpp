#include "semantic_slam/worlds/clearance.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// A box of 2 m with its centre at (5, 0, 1), and a small one far away.
World TwoBoxes() {
  World world;
  for (const float size_m : {2.0f, 0.1f}) {
    WorldObject object;
    object.instance = static_cast<InstanceId>(world.objects.size() + 1);
    object.surfaces.push_back({BoxMesh({0, 0, 0}, {size_m, size_m, size_m}), 0, std::nullopt});
    world.objects.push_back(object);
  }
  world.objects[0].T_world_object.translation() << 5.0, 0.0, 1.0;
  world.objects[1].T_world_object.translation() << -5.0, 0.0, 1.0;
  return world;
}

// The corners of meshes are floats.
constexpr double kRounding = 1e-6;

TEST(ClearanceTest, IsTheDistanceToTheNearestSurface) {
  const World world = TwoBoxes();
  const Clearance clearance(world);
  const NearestSurface before = clearance.At({3.0, 0.3, 1.2}, 0.0);
  EXPECT_NEAR(before.distance_m, 1.0, kRounding);
  EXPECT_EQ(before.instance, 1);
  EXPECT_EQ(clearance.At({-4.0, 0.0, 1.0}, 0.0).instance, 2);
}

TEST(ClearanceTest, ReachesToEdgesAndCorners) {
  const World world = TwoBoxes();
  const Clearance clearance(world);
  EXPECT_NEAR(clearance.At({3.0, 2.0, 1.0}, 0.0).distance_m, std::sqrt(2.0), kRounding);
  EXPECT_NEAR(clearance.At({3.0, 2.0, 3.0}, 0.0).distance_m, std::sqrt(3.0), kRounding);
}

TEST(ClearanceTest, CountsFromInsideToo) {
  const World world = TwoBoxes();
  EXPECT_NEAR(Clearance(world).At({4.3, 0.0, 1.0}, 0.0).distance_m, 0.3, kRounding);
}

TEST(ClearanceTest, FollowsWhoWalks) {
  World world = TwoBoxes();
  world.objects[0].walk.emplace(std::vector<Eigen::Vector2d>{{5, 0}, {15, 0}}, 1.0);
  const Clearance clearance(world);
  const double at_first = clearance.At({3.0, 0.0, 0.0}, 0.0).distance_m;
  EXPECT_NEAR(at_first, 1.0, kRounding);
  EXPECT_NEAR(clearance.At({3.0, 0.0, 0.0}, 2.0).distance_m, at_first + 2.0, kRounding);
}

TEST(ClearanceTest, AnEmptyWorldIsFree) {
  EXPECT_TRUE(std::isinf(Clearance(World()).At({0, 0, 0}, 0.0).distance_m));
}

}  // namespace
}  // namespace semantic_slam
