#include "semantic_slam/submaps/submap_merging.h"

#include <gtest/gtest.h>

#include "submaps_fixture.h"

namespace semantic_slam {
namespace {

constexpr double kResolutionM = 0.05;

// A submap that begins at a pose, with one scan of the room from there.
Submap SubmapOfRoom(SubmapId id, const Rigid2d& T_map_scan) {
  Submap submap(id, kResolutionM, 0, Rigid3d::Identity(), InSpace(T_map_scan));
  submap.Insert(DepthLikeScan(PlanarRoom(), T_map_scan), T_map_scan, ScanInserter());
  return submap;
}

TEST(SubmapMergingTest, HasNoCellsWhereNothingIsKnown) {
  const Submap empty(0, kResolutionM, 0, Rigid3d::Identity(), Rigid3d::Identity());
  EXPECT_TRUE(MergeSubmaps({}, kResolutionM).cells.empty());
  const OccupancyMap map = MergeSubmaps({&empty}, kResolutionM);
  EXPECT_TRUE(map.cells.empty());
  EXPECT_EQ(map.width, 0);
}

TEST(SubmapMergingTest, PutsWallsWhereTheyAreHoweverASubmapIsTurned) {
  for (const double yaw_rad : {0.0, 0.3, 1.2, -2.5}) {
    const Rigid2d T = MakeRigid2d({-0.4, 0.1}, yaw_rad);
    const Submap submap = SubmapOfRoom(0, T);
    const OccupancyMap map = MergeSubmaps({&submap}, kResolutionM);
    // One hit leaves 62 %, so look at what is above even. Two diagonals of half a cell, for the
    // submap's rounding and the map's.
    int walls = 0;
    for (int y = 0; y < map.height; ++y) {
      for (int x = 0; x < map.width; ++x) {
        if (map.cells[static_cast<std::size_t>(y) * map.width + x] <= 50) continue;
        const Eigen::Vector2d centre_m =
            map.origin_m + kResolutionM * Eigen::Vector2d(x + 0.5, y + 0.5);
        EXPECT_LT(PlanarRoom().Clearance(centre_m), 0.071);
        ++walls;
      }
    }
    EXPECT_GT(walls, 30);
    EXPECT_LT(CellAt(map, T * Eigen::Vector2d(0.5, 0.0)), 50) << "free ahead";
    EXPECT_EQ(CellAt(map, T * Eigen::Vector2d(-0.5, 0.0)), OccupancyMap::kUnknown) << "behind";
  }
}

TEST(SubmapMergingTest, AddsUpEvidence) {
  const Submap a = SubmapOfRoom(0, MakeRigid2d({0.0, 0.0}, 0.0));
  const Submap b = SubmapOfRoom(1, MakeRigid2d({0.0, 0.0}, 0.0));
  const Eigen::Vector2d wall_m(3.02, -0.3);
  const int once = CellAt(MergeSubmaps({&a}, kResolutionM), wall_m);
  const int twice = CellAt(MergeSubmaps({&a, &b}, kResolutionM), wall_m);
  EXPECT_EQ(once, 62);
  // Odds of 62 : 38 squared.
  EXPECT_EQ(twice, 73);
}

TEST(SubmapMergingTest, KeepsCellsWhereTheyAre) {
  const Submap a = SubmapOfRoom(0, MakeRigid2d({0.013, 0.007}, 0.3));
  const Submap b = SubmapOfRoom(1, MakeRigid2d({-1.111, 0.222}, 2.0));
  for (const OccupancyMap& map :
       {MergeSubmaps({&a}, kResolutionM), MergeSubmaps({&a, &b}, kResolutionM)}) {
    const Eigen::Vector2d cells = map.origin_m / kResolutionM;
    // Borders at whole multiples of the resolution, but for rounding.
    EXPECT_LT((cells - cells.array().round().matrix()).norm(), 1e-9);
  }
}

TEST(SubmapMergingTest, MissesLeastWhatOthersKnowToo) {
  const Submap here = SubmapOfRoom(0, MakeRigid2d({0.0, 0.0}, 0.0));
  const Submap behind = SubmapOfRoom(1, MakeRigid2d({0.0, 0.0}, M_PI));
  const Submap here_again = SubmapOfRoom(2, MakeRigid2d({0.0, 0.0}, 0.0));
  EXPECT_EQ(LeastMissed({&here, &behind, &here_again}), 0u)
      << "of two that know the same, the oldest";
  EXPECT_EQ(LeastMissed({&behind, &here, &here_again}), 1u);
  const Submap empty(3, kResolutionM, 0, Rigid3d::Identity(), Rigid3d::Identity());
  EXPECT_EQ(LeastMissed({&here, &behind, &empty}), 2u);
  EXPECT_EQ(LeastMissed({&empty}), 0u);
}

}  // namespace
}  // namespace semantic_slam
