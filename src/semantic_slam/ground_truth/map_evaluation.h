#pragma once

#include <optional>
#include <string>
#include <vector>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/common/class_list.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/evaluation/trajectory_report.h"
#include "semantic_slam/ground_truth/floor_plan_truth.h"
#include "semantic_slam/ground_truth/grid_score.h"
#include "semantic_slam/ground_truth/object_score.h"
#include "semantic_slam/ground_truth/object_visibility.h"
#include "semantic_slam/ground_truth/run_outputs.h"
#include "semantic_slam/ground_truth/voxel_label_score.h"
#include "semantic_slam/object_mapping/object_mapper.h"
#include "semantic_slam/semantic_grid/semantic_costs.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

struct MapEvaluationOptions {
  // What voxels' labels count as; those that do not, count neither for nor against the map.
  // Without: each as itself.
  std::optional<ClassList> voxel_classes;
  // Classes of objects that a map should hold; without: all but the ignored ones. Those of others
  // are neither missed nor extra.
  std::optional<ClassList> object_classes;
  std::string ignored_classes = ObjectMapperOptions().ignored_classes;
  int min_views = 3;           // poses that an object must be seen from, to be expected in the map
  double flight_band_m = 0.2;  // above and below the flight height: what a planar scan sees
  VisibilityOptions visibility;
  ObjectScoreOptions objects;
  GridScoreOptions grid;
  SemanticCostOptions costs;  // those that the semantic grid was made with

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("ignored_classes", self.ignored_classes);
    visit("min_views", self.min_views, 1, 1000);
    visit("flight_band_m", self.flight_band_m, 0.01, 10.0);
  }
};

// How much of the true area of tables and the like, seen from above, is marked.
struct HollowArea {
  CellCount in_objects;        // inside of a mapped object's footprint
  CellCount in_semantic_grid;  // costly, of those that reach the flight height
  CellCount in_grid;           // occupied, of the same
};

// How far the maps of a run are from the world that it was in. What is not there was not made.
struct MapEvaluation {
  Rigid3d T_world_map = Rigid3d::Identity();
  TrajectoryReport trajectory;
  OccupancyMap flight_plan;             // the truth in the flight band
  std::vector<MapObject> true_objects;  // those that stand still
  std::vector<bool> is_expected;        // of each, whether the map should hold it
  std::optional<VoxelLabelScore> voxels;
  std::optional<ObjectScore> objects;
  std::optional<GridScore> grid;           // against the flight plan
  std::optional<GridScore> semantic_grid;  // against the flight plan and what costs at its height
  HollowArea hollow;                       // without cells for what there is not
};

// The height [m] that most of a flight is at: the median of the camera's. Needs a pose.
double FlightHeight(const Trajectory& T_world_camera);

// The true floor plan about a height, as a planar scan there could see it.
FloorPlanOptions FlightBand(double height_m, double half_width_m);

// Compares a run with the world, after aligning its poses, positions and directions, to the true
// ones.
//
//   T_world_camera  the true trajectory of the optical frame
//
// Throws ConfigError if an option is out of range or a class is not in the vocabulary, InputError
// if the trajectories have too few stamps in common.
MapEvaluation EvaluateMaps(const World& world, const LabelVocabulary& vocabulary,
                           const Trajectory& T_world_camera, const CameraModel& camera,
                           const RunOutputs& outputs, const MapEvaluationOptions& options);

}  // namespace semantic_slam
