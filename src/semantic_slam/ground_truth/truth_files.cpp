#include "semantic_slam/ground_truth/truth_files.h"

#include <filesystem>

#include "semantic_slam/common/error.h"
#include "semantic_slam/ground_truth/floor_plan_truth.h"
#include "semantic_slam/ground_truth/map_evaluation.h"
#include "semantic_slam/ground_truth/object_truth.h"
#include "semantic_slam/object_mapping/object_map_file.h"
#include "semantic_slam/submaps/occupancy_map_file.h"

namespace semantic_slam {

void WriteTruthFiles(const std::string& folder, const World& world,
                     const LabelVocabulary& vocabulary, const Trajectory& T_world_camera) {
  if (T_world_camera.empty()) throw InputError("the trajectory is empty");
  const FloorPlanOptions flight =
      FlightBand(FlightHeight(T_world_camera), MapEvaluationOptions().flight_band_m);
  WriteObjectMap(std::filesystem::path(folder) / "objects.json", TrueObjects(world, vocabulary),
                 vocabulary);
  WriteOccupancyMap(folder, TrueFloorPlan(world, flight), "floor_plan_flight");
  WriteOccupancyMap(folder, TrueFloorPlan(world, {}), "floor_plan_projection");
}

}  // namespace semantic_slam
