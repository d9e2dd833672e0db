#include "semantic_slam/control/waypoint_file.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

class WaypointFileTest : public testing::Test {
 protected:
  Tour Load(const std::string& text) const { return LoadTour(folder_.Write("tour.yaml", text)); }
  void ExpectRefused(const std::string& text, std::initializer_list<const char*> parts) const {
    ExpectOneLineWith(MessageOf<ConfigError>([&] { Load(text); }), parts);
  }

 private:
  const TemporaryFolder folder_;
};

TEST_F(WaypointFileTest, ReadsWaypointsInOrder) {
  const Tour tour = Load(
      "max_speed_mps: 0.5\n"
      "waypoints:\n"
      "  - {position_m: [1, 2, 1.4], yaw_deg: 90, hold_s: 2}\n"
      "  - {position_m: [-3, 0.5, 1], yaw_deg: -270}\n");
  ASSERT_EQ(tour.waypoints.size(), 2u);
  EXPECT_EQ(tour.waypoints[0].position_m, Eigen::Vector3d(1, 2, 1.4));
  EXPECT_NEAR(tour.waypoints[0].yaw_rad, M_PI / 2, 1e-12);
  EXPECT_EQ(tour.waypoints[0].hold_s, 2.0);
  EXPECT_EQ(tour.waypoints[1].position_m, Eigen::Vector3d(-3, 0.5, 1));
  EXPECT_NEAR(tour.waypoints[1].yaw_rad, M_PI / 2, 1e-12);
  EXPECT_EQ(tour.waypoints[1].hold_s, 0.0);
  EXPECT_EQ(tour.max_speed_mps, 0.5);
}

TEST_F(WaypointFileTest, MayBeEmpty) {
  const Tour tour = Load("waypoints: []\n");
  EXPECT_TRUE(tour.waypoints.empty());
  EXPECT_FALSE(tour.max_speed_mps.has_value());
}

TEST_F(WaypointFileTest, NamesFileLineAndKeyOfAFault) {
  ExpectRefused("speed: 1\n", {"tour.yaml", "waypoints"});
  ExpectRefused("waypoints: 3\n", {"tour.yaml:1", "waypoints = 3", "a list"});
  ExpectRefused("waypoints:\n  - 3\n", {"tour.yaml:2", "waypoints/0", "mapping"});
  ExpectRefused("waypoints:\n  - {yaw_deg: 0}\n", {"tour.yaml", "waypoints/0/position_m"});
  ExpectRefused("waypoints:\n  - {position_m: [1, 2], yaw_deg: 0}\n",
                {"tour.yaml:2", "waypoints/0/position_m", "three numbers"});
  ExpectRefused("waypoints:\n  - {position_m: [1, .nan, 2], yaw_deg: 0}\n",
                {"tour.yaml:2", "waypoints/0/position_m", "three numbers"});
  ExpectRefused("waypoints:\n  - {position_m: [1, 2, 3], yaw_deg: .inf}\n",
                {"tour.yaml:2", "waypoints/0/yaw_deg", "[-360, 360]"});
  ExpectRefused("waypoints:\n  - {position_m: [1, 2, 3], yaw_deg: 0, hold_s: -1}\n",
                {"tour.yaml:2", "waypoints/0/hold_s = -1", "[0, 3600]"});
  ExpectRefused("waypoints:\n  - {position_m: [1, 2, 3], yaw_deg: 0, hold: 1}\n",
                {"tour.yaml:2", "waypoints/0/hold"});
  ExpectRefused("max_speed_mps: 0\nwaypoints: []\n", {"tour.yaml:1", "max_speed_mps = 0"});
  ExpectRefused("waypoints: [\n", {"tour.yaml", "not valid YAML"});
}

TEST_F(WaypointFileTest, NamesAMissingFile) {
  ExpectOneLineWith(MessageOf<ConfigError>([] { LoadTour("/nowhere/tour.yaml"); }),
                    {"/nowhere/tour.yaml"});
}

TEST_F(WaypointFileTest, TheToursOfThePackageCanBeRead) {
  const std::filesystem::path folder = std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/tours";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    EXPECT_GE(LoadTour(entry.path()).waypoints.size(), 2u) << entry.path();
  }
}

TEST(RelativeToFirstTest, TheFirstBecomesTheOrigin) {
  std::vector<Waypoint> waypoints(2);
  waypoints[0].position_m << 1, 2, 1.5;
  waypoints[0].yaw_rad = M_PI / 2;
  waypoints[1].position_m << 1, 5, 2.0;
  waypoints[1].yaw_rad = -M_PI;
  waypoints[1].hold_s = 3.0;
  const std::vector<Waypoint> relative = RelativeToFirst(waypoints);
  EXPECT_EQ(relative[0].position_m, Eigen::Vector3d::Zero());
  EXPECT_EQ(relative[0].yaw_rad, 0.0);
  EXPECT_TRUE(relative[1].position_m.isApprox(Eigen::Vector3d(3, 0, 0.5)));
  EXPECT_NEAR(relative[1].yaw_rad, M_PI / 2, 1e-12);
  EXPECT_EQ(relative[1].hold_s, 3.0);
  EXPECT_TRUE(RelativeToFirst({}).empty());
}

}  // namespace
}  // namespace semantic_slam
