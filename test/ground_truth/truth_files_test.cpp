#include "semantic_slam/ground_truth/truth_files.h"

#include <gtest/gtest.h>

#include "ground_truth/small_run.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/object_mapping/object_map_file.h"
#include "semantic_slam/submaps/occupancy_map_file.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

TEST(TruthFilesTest, HoldObjectsAndFloorPlans) {
  const TemporaryFolder folder;
  WriteTruthFiles(folder.path(), SmallWorld(), SmallVocabulary(), SmallTour());
  EXPECT_EQ(ReadObjectMap(folder / "objects.json", SmallVocabulary()).objects.size(), 2u);
  const OccupancyMap flight = ReadOccupancyMap(folder / "floor_plan_flight.yaml");
  const OccupancyMap all = ReadOccupancyMap(folder / "floor_plan_projection.yaml");
  const Eigen::Vector2d table(2.0, 1.5), lamp(3.5, 2.5);
  EXPECT_EQ(PercentAt(flight, table), 0);
  EXPECT_EQ(PercentAt(flight, lamp), 100);
  EXPECT_EQ(PercentAt(all, table), 100);
}

TEST(TruthFilesTest, RefusesAFlightOfNoPose) {
  const TemporaryFolder folder;
  EXPECT_THROW(WriteTruthFiles(folder.path(), SmallWorld(), SmallVocabulary(), {}), InputError);
}

}  // namespace
}  // namespace semantic_slam
