#include "semantic_slam/submaps/submap.h"

#include <gtest/gtest.h>

#include "submaps_fixture.h"

namespace semantic_slam {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kResolutionM = 0.05;
constexpr double kReachM = 5.0;

// A submap that begins at (1, 2), looking along y, on a keyframe at the map's origin.
Submap MakeSubmap() {
  return Submap(7, kResolutionM, 3, Rigid3d::Identity(),
                InSpace(MakeRigid2d({1.0, 2.0}, M_PI / 2)));
}

TEST(SubmapTest, LiesWhereItsKeyframePutsIt) {
  const Submap submap = MakeSubmap();
  EXPECT_EQ(submap.id(), 7);
  EXPECT_EQ(submap.keyframe(), 3);
  EXPECT_TRUE(submap.T_map_submap().isApprox(MakeRigid2d({1.0, 2.0}, M_PI / 2), kRounding));
}

TEST(SubmapTest, HoldsScansInItsOwnFrame) {
  Submap submap = MakeSubmap();
  PlanarScan scan;
  scan.beams = {{1.02f, 0.0f, 1.02f}};
  submap.Insert(scan, MakeRigid2d({1.0, 2.0}, 0.0), ScanInserter());
  // Ahead in the map is to the right in the submap.
  EXPECT_GT(submap.grid().At({0, -21}), 0);
  EXPECT_EQ(submap.scans(), 1);
}

TEST(SubmapTest, MeasuresHowFarTheCameraWentNotHowMuchItMoved) {
  Submap submap = MakeSubmap();
  for (int i = 0; i < 100; ++i) {
    const double sway_m = i % 2 == 0 ? 0.2 : -0.2;
    submap.Insert(PlanarScan(), MakeRigid2d({1.0 + sway_m, 2.0}, M_PI / 2 + sway_m),
                  ScanInserter());
  }
  EXPECT_NEAR(submap.distance_m(), 0.2, kRounding);
  EXPECT_NEAR(submap.turn_rad(), 0.2, kRounding);
  EXPECT_EQ(submap.scans(), 100);
}

TEST(SubmapTest, FollowsItsKeyframe) {
  Submap submap = MakeSubmap();
  const Rigid2d correction = MakeRigid2d({0.3, -0.1}, 0.2);
  EXPECT_TRUE(submap.Follow(InSpace(correction), kReachM, 0.02));
  EXPECT_TRUE(
      submap.T_map_submap().isApprox(correction * MakeRigid2d({1.0, 2.0}, M_PI / 2), kRounding));
}

TEST(SubmapTest, LeavesSmallCorrectionsUntilTheyAddUp) {
  Submap submap = MakeSubmap();
  const auto shifted = [](double x_m) { return InSpace(MakeRigid2d({x_m, 0.0}, 0.0)); };
  EXPECT_FALSE(submap.Follow(shifted(0.015), kReachM, 0.02));
  EXPECT_EQ(submap.T_map_submap().translation().x(), 1.0);
  EXPECT_TRUE(submap.Follow(shifted(0.03), kReachM, 0.02));
  EXPECT_NEAR(submap.T_map_submap().translation().x(), 1.03, kRounding);
  // 5 mrad move a wall 5 m away by 2.5 cm.
  EXPECT_TRUE(submap.Follow(InSpace(MakeRigid2d({0.03, 0.0}, 0.005)), kReachM, 0.02));
}

}  // namespace
}  // namespace semantic_slam
