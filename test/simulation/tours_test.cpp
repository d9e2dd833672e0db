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

INSTANTIATE_TEST_SUITE_P(OfThePackage, ToursTest, testing::Values("home", "office"));

}  // namespace
}  // namespace semantic_slam
