#include "semantic_slam/ground_truth/surface_labels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"

namespace semantic_slam {
namespace {

TEST(SurfaceLabelsTest, TellsTheNearestOfEachClass) {
  const SurfaceLabels surfaces(SmallWorld());
  // 6 cm over the floor, 4 cm before the wall.
  const auto nearby = surfaces.Around({0.04, 1.5, 0.06}, 0.1);
  ASSERT_EQ(nearby.size(), 2u);
  EXPECT_EQ(nearby[0].label, kWall);
  EXPECT_NEAR(nearby[0].distance_m, 0.04, 1e-6);  // meshes are floats
  EXPECT_EQ(nearby[1].label, kFloor);
  EXPECT_NEAR(nearby[1].distance_m, 0.06, 1e-6);
  EXPECT_TRUE(surfaces.Around({1.0, 1.0, 1.2}, 0.3).empty());
}

TEST(SurfaceLabelsTest, DistancesAreThoseOfFacesEdgesAndCorners) {
  const SurfaceLabels surfaces(MakeWorld({MakeObject(kLamp, BoxMesh({0, 0, 0}, {1, 1, 1}))}));
  const auto distance = [&](const Eigen::Vector3d& p) {
    return surfaces.Around(p, 1.0).at(0).distance_m;
  };
  EXPECT_NEAR(distance({0.1, 0.2, 0.7}), 0.2, 1e-6);
  EXPECT_NEAR(distance({0.8, 0.1, 0.9}), 0.5, 1e-6);                   // an edge: 0.3 and 0.4
  EXPECT_NEAR(distance({0.7, 0.7, 0.7}), 0.2 * std::sqrt(3.0), 1e-6);  // a corner
  EXPECT_NEAR(distance({0.0, 0.0, 0.4}), 0.1, 1e-6);                   // inside
}

TEST(SurfaceLabelsTest, AReachThatEndsAtTheSurfaceReachesIt) {
  const SurfaceLabels surfaces(MakeWorld({MakeObject(kLamp, BoxMesh({0, 0, 0}, {1, 1, 1}))}));
  EXPECT_EQ(surfaces.Around({0, 0, 0.75}, 0.25).size(), 1u);
  EXPECT_EQ(surfaces.Around({0, 0, 0.75}, 0.249).size(), 0u);
}

TEST(SurfaceLabelsTest, WhatMovesIsNotInIt) {
  WorldObject walker = MakeObject(kChair, BoxMesh({0, 0, 1}, {0.4f, 0.4f, 1.8f}));
  walker.walk.emplace(std::vector<Eigen::Vector2d>{{1, 1}, {3, 1}}, 1.0);
  EXPECT_TRUE(SurfaceLabels(MakeWorld({walker})).Around({0.2, 0, 1}, 0.3).empty());
}

TEST(SurfaceLabelsTest, SightIsBlockedByWhatStandsBetween) {
  const SurfaceLabels surfaces(SmallWorld());
  const Eigen::Vector3d lamp(3.36, 2.4, 1.5);  // a little before its surface
  EXPECT_FALSE(surfaces.IsBlocked({0.5, 0.5, 1.5}, lamp));
  EXPECT_TRUE(surfaces.IsBlocked({0.5, 0.5, 1.5}, {4.5, 1.0, 1.5}));      // a wall
  EXPECT_TRUE(surfaces.IsBlocked({2.0, 1.5, 0.2}, {2.1, 1.6, 1.5}));      // the table's top
  EXPECT_FALSE(surfaces.IsBlocked({2.0, 1.5, 0.2}, {2.1, 1.6, 1.5}, 3));  // that is the table
  EXPECT_FALSE(surfaces.IsBlocked({1.0, 1.5, 0.2}, {3.0, 1.5, 0.2}));     // between its legs
}

TEST(SurfaceLabelsTest, SightMayEndAtASurface) {
  const SurfaceLabels surfaces(SmallWorld());
  EXPECT_FALSE(surfaces.IsBlocked({0.5, 0.5, 1.5}, {0.5, 0.5, 0.0}));
  EXPECT_FALSE(surfaces.IsBlocked({1, 1, 1}, {1, 1, 1}));
}

TEST(SurfaceLabelsTest, SightFindsAThinThingFromEveryDirection) {
  const SurfaceLabels surfaces(
      MakeWorld({MakeObject(kLamp, EllipsoidMesh({0, 0, 0}, {0.1f, 0.1f, 0.1f}))}));
  for (int i = 0; i < 360; ++i) {
    const double angle = M_PI * i / 180.0;
    const Eigen::Vector3d from(3 * std::cos(angle), 3 * std::sin(angle), 0.7 * std::sin(3 * angle));
    EXPECT_TRUE(surfaces.IsBlocked(from, -from)) << i;
  }
}

}  // namespace
}  // namespace semantic_slam
