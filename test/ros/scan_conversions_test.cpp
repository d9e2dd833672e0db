#include "semantic_slam_ros/scan_conversions.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::PlanarScan;
using semantic_slam::Stamp;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

PlanarScan FourBeams() {
  PlanarScan scan;
  scan.stamp = Stamp{5'000'000'007};
  scan.first_bearing_rad = -0.3;
  scan.bearing_step_rad = 0.2;
  scan.max_range_m = 5.0;
  scan.beams = {{2.5f, 0.0f, 2.4f}, {kNan, 0.0f, 5.0f}, {kNan, 0.0f, 4.9f}, {}};
  return scan;
}

TEST(ScanConversionsTest, TellsHitsFreeAndUnknownByRep117) {
  const sensor_msgs::LaserScan msg = ToLaserScan(FourBeams(), 0.3, "level");
  ASSERT_EQ(msg.ranges.size(), 4u);
  EXPECT_FLOAT_EQ(msg.ranges[0], 2.5f);
  EXPECT_EQ(msg.ranges[1], std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(msg.ranges[2])) << "free for a part of the way only";
  EXPECT_TRUE(std::isnan(msg.ranges[3]));
}

TEST(ScanConversionsTest, DoesNotClearWhatIsNotSeenNearby) {
  PlanarScan scan = FourBeams();
  scan.beams[1].free_from_m = 1.0f;
  EXPECT_TRUE(std::isnan(ToLaserScan(scan, 0.3, "level").ranges[1]));
}

TEST(ScanConversionsTest, DescribesItsBeams) {
  const sensor_msgs::LaserScan msg = ToLaserScan(FourBeams(), 0.3, "level");
  EXPECT_EQ(msg.header.frame_id, "level");
  EXPECT_EQ(msg.header.stamp, ros::Time(5, 7));
  EXPECT_FLOAT_EQ(msg.angle_min, -0.3f);
  EXPECT_FLOAT_EQ(msg.angle_max, 0.3f);
  EXPECT_FLOAT_EQ(msg.angle_increment, 0.2f);
  EXPECT_FLOAT_EQ(msg.range_min, 0.3f);
  EXPECT_FLOAT_EQ(msg.range_max, 5.0f);
}

TEST(ScanConversionsTest, TakesAScanWithoutBeams) {
  EXPECT_TRUE(ToLaserScan(PlanarScan(), 0.3, "level").ranges.empty());
}

}  // namespace
}  // namespace semantic_slam_ros
