// The tours of the worlds that come with the package, flown by the true pose: nothing is touched.

#include <string>

#include <gtest/gtest.h>

#include "semantic_slam/control/flight.h"
#include "semantic_slam/control/waypoint_file.h"
#include "semantic_slam/worlds/clearance.h"
#include "semantic_slam/worlds/world_file.h"

namespace semantic_slam {
namespace {

// The Hummingbird from its centre to the tips of its propellers.
constexpr double kDroneRadiusM = 0.27;
constexpr int kSamplesPerS = 5;

class ToursTest : public testing::TestWithParam<const char*> {};

TEST_P(ToursTest, TouchNothing) {
  const std::string config = SEMANTIC_SLAM_SOURCE_DIR "/config/";
  const World world = LoadWorld(config + "worlds/" + GetParam() + ".yaml",
                                LabelVocabulary::Load(config + "labels.yaml"));
  const Tour tour = LoadTour(config + "tours/" + GetParam() + ".yaml");
  FlightOptions options;
  if (tour.max_speed_mps) options.follower.max_speed_mps = *tour.max_speed_mps;
  const Clearance clearance(world);
  for (const FlightSample& sample : FlyWaypoints(tour.waypoints, options, kSamplesPerS)) {
    const Eigen::Vector3d place = sample.state.T_world_base.translation();
    const NearestSurface nearest = clearance.At(place, sample.stamp.seconds());
    EXPECT_GT(nearest.distance_m, kDroneRadiusM)
        << "from " << world.objects[nearest.instance - 1].name << " at " << place.transpose()
        << ", " << sample.stamp.seconds() << " s";
  }
}

// Leaves room for a drone that knows its pose only roughly and cuts corners.
TEST_P(ToursTest, KeepTheirDistance) {
  constexpr double kRoomM = 0.45;
  const std::string config = SEMANTIC_SLAM_SOURCE_DIR "/config/";
  const World world = LoadWorld(config + "worlds/" + GetParam() + ".yaml",
                                LabelVocabulary::Load(config + "labels.yaml"));
  const std::vector<Waypoint> waypoints =
      LoadTour(config + "tours/" + GetParam() + ".yaml").waypoints;
  const Clearance clearance(world);
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    for (double share = 0.0; share < 1.0; share += 0.1) {
      const Eigen::Vector3d place =
          (1.0 - share) * waypoints[i].position_m + share * waypoints[i + 1].position_m;
      const NearestSurface nearest = clearance.At(place, 0.0);
      EXPECT_GT(nearest.distance_m, kRoomM)
          << "from " << world.objects[nearest.instance - 1].name << " at " << place.transpose();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThePackage, ToursTest, testing::Values("home", "office"));

}  // namespace
}  // namespace semantic_slam
