#include "testing/planar_world.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr double kRounding = 1e-6;  // ranges are floats

TEST(PlanarWorldTest, MeasuresDistancesToWalls) {
  const PlanarWorld room = PlanarRoom();
  EXPECT_NEAR(room.Distance({0.0, 0.0}, {1.0, 0.0}), 3.0, kRounding);
  EXPECT_NEAR(room.Distance({0.0, 0.7}, {-1.0, 0.0}), 3.0, kRounding);
  EXPECT_NEAR(room.Distance({2.0, 0.8}, {1.0, 0.0}), 1.5, kRounding) << "into the niche";
  EXPECT_TRUE(std::isinf(PlanarCorridor().Distance({0.0, 0.0}, {1.0, 0.0})));
}

TEST(PlanarWorldTest, MeasuresTheClearance) {
  EXPECT_NEAR(PlanarRoom().Clearance({-2.0, 1.5}), 0.5, kRounding);
  EXPECT_NEAR(PlanarRoom().Clearance({-4.0, -2.0}), 1.0, kRounding) << "to a corner, from outside";
}

TEST(PlanarWorldTest, ScansFromAPose) {
  const PlanarScan scan = PlanarCorridor().Scan(MakeRigid2d({5.0, 0.5}, M_PI / 2), M_PI, 181, 1.2);
  ASSERT_EQ(scan.beams.size(), 181u);
  EXPECT_NEAR(scan.beams[90].hit_m, 0.5, kRounding) << "ahead, to the left wall";
  EXPECT_EQ(scan.beams[0].status(), BeamStatus::kFree) << "along the corridor";
  EXPECT_NEAR(scan.beams[0].free_to_m, 1.2, kRounding);
}

}  // namespace
}  // namespace semantic_slam
