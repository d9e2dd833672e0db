#include "semantic_slam/scan/planar_scan.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(PlanarScanTest, TellsHitFreeAndUnknownApart) {
  EXPECT_EQ(ScanBeam().status(), BeamStatus::kUnknown);
  EXPECT_EQ((ScanBeam{kNan, 0.0f, 2.0f}).status(), BeamStatus::kFree);
  EXPECT_EQ((ScanBeam{kNan, 2.0f, 2.0f}).status(), BeamStatus::kUnknown);
  EXPECT_EQ((ScanBeam{1.5f, 0.0f, 0.0f}).status(), BeamStatus::kHit);
}

TEST(PlanarScanTest, PutsHitsWhereTheirBeamsPoint) {
  PlanarScan scan;
  scan.first_bearing_rad = -M_PI / 2;
  scan.bearing_step_rad = M_PI / 2;
  scan.beams = {{2.0f, 0.0f, 2.0f}, {kNan, 0.0f, 5.0f}, {3.0f, 0.0f, 0.0f}};
  const PlanarPoints points = HitPoints(scan);
  ASSERT_EQ(points.size(), 2u);
  // To the right is -y, to the left is +y. The tolerances are for rounding only.
  EXPECT_LT((points[0] - Eigen::Vector2d(0.0, -2.0)).norm(), 1e-12);
  EXPECT_LT((points[1] - Eigen::Vector2d(0.0, 3.0)).norm(), 1e-12);
}

TEST(PlanarScanTest, IsEmptyWithoutBeams) {
  EXPECT_TRUE(HitPoints(PlanarScan()).empty());
}

}  // namespace
}  // namespace semantic_slam
