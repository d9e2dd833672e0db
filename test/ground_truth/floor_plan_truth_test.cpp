#include "semantic_slam/ground_truth/floor_plan_truth.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

int At(const OccupancyMap& map, double x_m, double y_m) {
  const int x = static_cast<int>((x_m - map.origin_m.x()) / map.resolution_m);
  const int y = static_cast<int>((y_m - map.origin_m.y()) / map.resolution_m);
  return map.cells[static_cast<std::size_t>(y) * map.width + x];
}

FloorPlanOptions Band(double min_m, double max_m) {
  FloorPlanOptions options;
  options.min_height_m = min_m;
  options.max_height_m = max_m;
  return options;
}

double OccupiedM2(const OccupancyMap& map) {
  return std::count(map.cells.begin(), map.cells.end(), 100) * map.resolution_m * map.resolution_m;
}

TEST(FloorPlanTruthTest, ARoomIsFreeWithinItsWallsAndUnknownOutside) {
  const World world =
      MakeWorld({MakeStructure(kFloor, FloorMesh(4, 3)), MakeStructure(kWall, WallsMesh(4, 3))});
  const OccupancyMap plan = TrueFloorPlan(world, {});
  EXPECT_EQ(plan.resolution_m, 0.05);
  EXPECT_NEAR(plan.origin_m.x(), -0.6, 1e-9);  // wall and margin
  EXPECT_NEAR(plan.origin_m.y(), -0.6, 1e-9);
  EXPECT_EQ(plan.width, 104);  // 5.2 m
  EXPECT_EQ(plan.height, 84);
  EXPECT_EQ(At(plan, 2.0, 1.5), 0);
  EXPECT_EQ(At(plan, 0.025, 0.025), 0);
  EXPECT_EQ(At(plan, -0.025, 1.5), 100);
  EXPECT_EQ(At(plan, -0.075, 1.5), 100);
  EXPECT_EQ(At(plan, -0.125, 1.5), OccupancyMap::kUnknown);
  EXPECT_EQ(At(plan, 4.3, 1.5), OccupancyMap::kUnknown);
  // Just the walls, though their faces lie on borders of cells.
  EXPECT_NEAR(OccupiedM2(plan), 4.2 * 3.2 - 4.0 * 3.0, 1e-9);
}

TEST(FloorPlanTruthTest, ATableIsItsLegsOrItsTopByTheBand) {
  const World world = SmallWorld();
  const OccupancyMap below = TrueFloorPlan(world, Band(0.2, 0.5));
  EXPECT_EQ(At(below, 2.0, 1.5), 0);
  EXPECT_EQ(At(below, 1.45, 1.15), 100);  // a leg
  const OccupancyMap all = TrueFloorPlan(world, {});
  EXPECT_EQ(At(all, 2.0, 1.5), 100);
  EXPECT_EQ(At(all, 2.57, 1.5), 100);
  EXPECT_EQ(At(all, 2.65, 1.5), 0);
  const OccupancyMap above = TrueFloorPlan(world, Band(1.2, 1.6));
  EXPECT_EQ(At(above, 2.0, 1.5), 0);
  EXPECT_EQ(At(above, 3.5, 2.5), 100);  // the lamp
}

TEST(FloorPlanTruthTest, SolidsAreFilled) {
  const World world =
      MakeWorld({MakeStructure(kFloor, FloorMesh(6, 6)), MakeStructure(kWall, WallsMesh(6, 6)),
                 MakeObject(kLamp, BoxMesh({3, 3, 1.25f}, {2, 2, 2.5f}))});
  const OccupancyMap plan = TrueFloorPlan(world, Band(1.0, 1.1));
  EXPECT_EQ(At(plan, 3.0, 3.0), 100);  // far from every surface of the pillar
  EXPECT_NEAR(OccupiedM2(plan), 6.2 * 6.2 - 6.0 * 6.0 + 4.0, 1e-9);
}

TEST(FloorPlanTruthTest, TheInsideOfACupboardOfBoardsIsNoFreeSpace) {
  World world =
      MakeWorld({MakeStructure(kFloor, FloorMesh(4, 3)), MakeStructure(kWall, WallsMesh(4, 3)),
                 MakeObject(kLamp, Merged({BoxMesh({2, 1, 1}, {1, 0.02f, 2}),
                                           BoxMesh({2, 1.6f, 1}, {1, 0.02f, 2}),
                                           BoxMesh({1.5f, 1.3f, 1}, {0.02f, 0.6f, 2}),
                                           BoxMesh({2.5f, 1.3f, 1}, {0.02f, 0.6f, 2})}))});
  EXPECT_EQ(At(TrueFloorPlan(world, Band(1.0, 1.4)), 2.0, 1.3), 100);
  FloorPlanOptions open = Band(1.0, 1.4);
  open.max_enclosed_m2 = 0.1;  // the cupboard holds 0.5
  EXPECT_EQ(At(TrueFloorPlan(world, open), 2.0, 1.3), 0);
}

TEST(FloorPlanTruthTest, ThinThingsThatStandUprightAreSeen) {
  const World world = MakeWorld(
      {MakeStructure(kFloor, FloorMesh(4, 3)),
       MakeObject(kLamp, QuadMesh({1.01f, 1.01f, 2}, {1, 0.5f, 0}, {0, 0, -2}))});  // a sheet
  const OccupancyMap plan = TrueFloorPlan(world, Band(1.0, 1.1));
  for (double t = 0.0; t < 1.0; t += 0.01) {
    EXPECT_EQ(At(plan, 1.01 + t, 1.01 + 0.5 * t), 100) << t;
  }
}

TEST(FloorPlanTruthTest, WhoWalksIsNotInIt) {
  World world = SmallWorld();
  const OccupancyMap before = TrueFloorPlan(world, {});
  WorldObject walker = MakeObject(kChair, BoxMesh({0, 0, 1}, {0.4f, 0.4f, 1.8f}));
  walker.walk.emplace(std::vector<Eigen::Vector2d>{{1, 1}, {3, 1}}, 1.0);
  world.objects.push_back(walker);
  EXPECT_EQ(TrueFloorPlan(world, {}).cells, before.cells);
}

TEST(FloorPlanTruthTest, AnEmptyWorldHasNoCells) {
  EXPECT_TRUE(TrueFloorPlan(World(), {}).cells.empty());
}

TEST(FloorPlanTruthTest, RefusesABandUpsideDown) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { TrueFloorPlan(SmallWorld(), Band(2.0, 1.0)); }),
                    {"min_height_m"});
}

}  // namespace
}  // namespace semantic_slam
