#include "semantic_slam/submaps/planar_slam.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "submaps_fixture.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

GridSlamOptions LaserOptions() {
  GridSlamOptions options;
  options.correlative_matcher.linear_window_m = 0.2;
  options.correlative_matcher.angular_window_deg = 10.0;
  return options;
}

PlanarScan LaserScan(const Rigid2d& T_world_scan) {
  return PlanarRoom().Scan(T_world_scan, M_PI, 360, 20.0);
}

// A way around the room, and what odometry that turns 3 % too far makes of it.
Rigid2d Step() {
  return MakeRigid2d({0.06, 0.0}, 0.08);
}
Rigid2d OdometryStep() {
  return MakeRigid2d({0.063, 0.002}, 0.0824);
}

TEST(PlanarSlamTest, FollowsTheScannerBetterThanOdometry) {
  PlanarSlam slam(LaserOptions());
  const Rigid2d start = MakeRigid2d({0.0, -1.0}, 0.0);
  Rigid2d T_world_scan = start, T_odom_scan = Rigid2d::Identity(), T_map_scan;
  for (int i = 0; i < 120; ++i) {
    T_map_scan = slam.Add(LaserScan(T_world_scan), T_odom_scan);
    if (i == 119) break;
    T_world_scan = T_world_scan * Step();
    T_odom_scan = T_odom_scan * OdometryStep();
  }
  const Rigid2d truth = start.inverse() * T_world_scan;
  // Odometry is 0.29 rad off by then; matched, the scanner is within a cell or two.
  EXPECT_GT(std::abs(Yaw(truth.inverse() * T_odom_scan)), 0.2);
  EXPECT_LT((T_map_scan.translation() - truth.translation()).norm(), 0.1);
  EXPECT_LT(std::abs(Yaw(truth.inverse() * T_map_scan)), 0.03);
  EXPECT_GT(slam.submaps(), 2u);
}

TEST(PlanarSlamTest, BelievesOdometryWhereNothingFits) {
  PlanarSlam slam(LaserOptions());
  slam.Add(LaserScan(MakeRigid2d({0.0, 0.0}, 0.0)), MakeRigid2d({5.0, 5.0}, 1.0));
  const Rigid2d step = MakeRigid2d({0.3, 0.1}, 0.2);
  const Rigid2d T_map_scan = slam.Add(PlanarScan(), MakeRigid2d({5.0, 5.0}, 1.0) * step);
  EXPECT_TRUE(T_map_scan.isApprox(step, 1e-9)) << "the map begins at the first scan";
}

TEST(PlanarSlamTest, StandingStillAddsNothing) {
  PlanarSlam slam(LaserOptions());
  const PlanarScan scan = LaserScan(MakeRigid2d({0.0, 0.0}, 0.0));
  slam.Add(scan, Rigid2d::Identity());
  const OccupancyMap before = slam.Render();
  for (int i = 0; i < 20; ++i) slam.Add(scan, Rigid2d::Identity());
  EXPECT_EQ(slam.Render().cells, before.cells);
  EXPECT_EQ(slam.submaps(), 1u);
}

TEST(PlanarSlamTest, RefusesOptionsOutOfRange) {
  GridSlamOptions options;
  options.grid_mapper.min_motion_m = -1.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { PlanarSlam{options}; }),
            "min_motion_m = -1, but must be in [0, 10]");
}

}  // namespace
}  // namespace semantic_slam
