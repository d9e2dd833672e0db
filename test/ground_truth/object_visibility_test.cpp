#include "semantic_slam/ground_truth/object_visibility.h"

#include <gtest/gtest.h>

#include "ground_truth/small_run.h"
#include "semantic_slam/common/error.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

std::vector<int> Count(const World& world, const Trajectory& trajectory,
                       const VisibilityOptions& options = {}) {
  return CountViews(world, SurfaceLabels(world), trajectory, *SmallCamera(), options);
}

TEST(ObjectVisibilityTest, CountsThePosesThatAnObjectIsSeenFrom) {
  const World world = SmallWorld();  // the third object is the table, the fourth the lamp
  const Eigen::Vector3d corner(0.3, 0.3, 1.2);
  const double to_lamp = std::atan2(2.2, 3.2);
  const std::vector<int> views =
      Count(world, {Looking(0, corner, to_lamp), Looking(1, corner, to_lamp),
                    Looking(2, corner, to_lamp + M_PI)});
  ASSERT_EQ(views.size(), 4u);
  EXPECT_EQ(views[3], 2);  // from the third pose it is behind the camera
}

TEST(ObjectVisibilityTest, NothingIsSeenThroughAWallOrFromTooFar) {
  World world = SmallWorld();
  EXPECT_EQ(Count(world, {Looking(0, {3.5, -1.5, 1.2}, M_PI_2)})[3], 0);
  world.objects[1].surfaces.clear();
  EXPECT_EQ(Count(world, {Looking(0, {3.5, -1.0, 1.2}, M_PI_2)})[3], 1);
  EXPECT_EQ(Count(world, {Looking(0, {3.5, -3.0, 1.2}, M_PI_2)})[3], 0);  // 5.5 m
}

TEST(ObjectVisibilityTest, PosesInQuickSuccessionAreOne) {
  const World world = SmallWorld();
  Trajectory hovering;
  for (int i = 0; i <= 30; ++i) hovering.push_back(Looking(i / 30.0, {1.5, 2.5, 1.2}, 0.0));
  EXPECT_EQ(Count(world, hovering)[3], 3);  // at 0, 0.5 and 1 s
}

TEST(ObjectVisibilityTest, WhatMovesIsNeverCounted) {
  World world = SmallWorld();
  world.objects[3].walk.emplace(std::vector<Eigen::Vector2d>{{1, 1}, {3, 1}}, 1.0);
  EXPECT_EQ(Count(world, {Looking(0, {1.5, 2.5, 1.2}, 0.0)})[3], 0);
}

TEST(ObjectVisibilityTest, RefusesOptionsOutOfRange) {
  VisibilityOptions options;
  options.min_share = 0.0;
  EXPECT_THROW(Count(SmallWorld(), {}, options), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
