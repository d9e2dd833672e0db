#include "semantic_slam/ground_truth/map_evaluation.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "semantic_slam/common/label_check.h"
#include "semantic_slam/evaluation/alignment.h"
#include "semantic_slam/ground_truth/object_truth.h"

namespace semantic_slam {
namespace {

constexpr double kAreaSampleM = 0.02;
constexpr double kReachM = 2.0;  // from a camera to what it sees

// By label.
std::vector<bool> ClassesOfInterest(const MapEvaluationOptions& options,
                                    const LabelVocabulary& vocabulary) {
  std::vector<bool> is_of_interest(256, true);
  if (options.object_classes) {
    for (int label = 0; label < 256; ++label) {
      is_of_interest[label] = options.object_classes->of_label[label] != kIgnoredClass;
    }
  }
  for (const LabelId label : FindLabels("ignored_classes", options.ignored_classes, vocabulary)) {
    is_of_interest[label] = false;
  }
  return is_of_interest;
}

// T_world_map that fits best to what the cameras see: their positions and places about them.
// Positions alone leave it open how a map is turned about a straight path.
Rigid3d AlignViews(const std::vector<MatchedPose>& matches) {
  std::vector<MatchedPose> places;
  for (const MatchedPose& match : matches) {
    places.push_back(match);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Translation3d beside(kReachM * Eigen::Vector3d::Unit(axis));
      places.push_back(
          {match.stamp, match.T_reference_sensor * beside, match.T_estimate_sensor * beside});
    }
  }
  return AlignTrajectories(places);
}

LabelId ClassOf(const MapObject& object) {
  return object.labels.front().label;
}

// A run and its world, with all that several comparisons need.
class Evaluator {
 public:
  Evaluator(const World& world, const LabelVocabulary& vocabulary, const Trajectory& T_world_camera,
            const CameraModel& camera, const RunOutputs& outputs,
            const MapEvaluationOptions& options)
      : vocabulary_(vocabulary),
        outputs_(outputs),
        options_(options),
        is_of_interest_(ClassesOfInterest(options, vocabulary)),
        surfaces_(world) {
    result_.trajectory = CompareTrajectories(T_world_camera, outputs.trajectory, {}, {});
    result_.T_world_map = AlignViews(result_.trajectory.matches);
    result_.flight_plan =
        TrueFloorPlan(world, FlightBand(FlightHeight(T_world_camera), options.flight_band_m));
    result_.true_objects = TrueObjects(world, vocabulary).objects;
    ExpectSeenObjects(CountViews(world, surfaces_, T_world_camera, camera, options.visibility));
  }

  MapEvaluation Run() && {
    if (outputs_.tree) {
      result_.voxels =
          ScoreVoxelLabels(*outputs_.tree, result_.T_world_map, surfaces_,
                           options_.voxel_classes ? &*options_.voxel_classes : nullptr);
    }
    if (outputs_.objects) ScoreObjectMap();
    if (outputs_.grid) {
      result_.grid = ScoreGrid(result_.flight_plan, *outputs_.grid, Flattened(result_.T_world_map),
                               options_.grid);
    }
    if (outputs_.semantic_grid) {
      result_.semantic_grid = ScoreGrid(PlanWithObstacles(), *outputs_.semantic_grid,
                                        Flattened(result_.T_world_map), options_.grid);
    }
    MeasureHollowArea();
    return std::move(result_);
  }

 private:
  // `views` are parallel to the world's objects.
  void ExpectSeenObjects(const std::vector<int>& views) {
    for (const MapObject& object : result_.true_objects) {
      const auto in_world = static_cast<std::size_t>(object.id - 1);
      result_.is_expected.push_back(is_of_interest_[ClassOf(object)] &&
                                    views[in_world] >= options_.min_views);
    }
  }

  // By the classes that their labels count as.
  std::vector<MapObject> AsCounted(std::vector<MapObject> objects) const {
    if (!options_.object_classes) return objects;
    for (MapObject& object : objects) {
      LabelId& label = object.labels.front().label;
      const int c = options_.object_classes->of_label[label];
      if (c != kIgnoredClass) label = options_.object_classes->labels[c];
    }
    return objects;
  }

  // Estimated objects of classes that are not asked for are no errors.
  void ScoreObjectMap() {
    std::vector<MapObject> estimate;
    for (const MapObject& object : outputs_.objects->objects) {
      if (is_of_interest_[ClassOf(object)]) estimate.push_back(object);
    }
    result_.objects = ScoreObjects(AsCounted(result_.true_objects), AsCounted(estimate),
                                   result_.T_world_map, result_.is_expected, options_.objects);
  }

  // Whether an object costs anything at the flight height.
  bool IsObstacle(const MapObject& true_object) const {
    const MapObject in_map = InWorld(true_object, result_.T_world_map.inverse());
    return SemanticCosts(options_.costs).OfObject(in_map, vocabulary_) > 0.0;
  }

  OccupancyMap PlanWithObstacles() const {
    OccupancyMap plan = result_.flight_plan;
    for (const MapObject& object : result_.true_objects) {
      if (IsObstacle(object)) FillPolygon(object.footprint_m, plan);
    }
    return plan;
  }

  // What the mapped objects cover, in the world frame.
  OccupancyMap MappedFootprints() const {
    OccupancyMap covered = result_.flight_plan;
    std::fill(covered.cells.begin(), covered.cells.end(), std::int8_t{0});
    for (const MapObject& object : outputs_.objects->objects) {
      FillPolygon(InWorld(object, result_.T_world_map).footprint_m, covered);
    }
    return covered;
  }

  void MeasureHollowArea() {
    std::vector<ConvexPolygon> all, at_flight_height;
    for (std::size_t i = 0; i < result_.true_objects.size(); ++i) {
      const MapObject& object = result_.true_objects[i];
      const bool is_hollow =
          vocabulary_[ClassOf(object)].hollow && object.hollow != Hollowness::kNo;
      if (!result_.is_expected[i] || !is_hollow) continue;
      all.push_back(object.footprint_m);
      if (IsObstacle(object)) at_flight_height.push_back(object.footprint_m);
    }
    const auto area = [&](const std::vector<ConvexPolygon>& polygons, const OccupancyMap& map,
                          const Rigid2d& T_world_grid) {
      return OccupiedArea(polygons, map, T_world_grid, kAreaSampleM, options_.grid);
    };
    const Rigid2d T = Flattened(result_.T_world_map);
    HollowArea& hollow = result_.hollow;
    if (outputs_.objects) hollow.in_objects = area(all, MappedFootprints(), Rigid2d::Identity());
    if (outputs_.grid) hollow.in_grid = area(at_flight_height, *outputs_.grid, T);
    if (outputs_.semantic_grid) {
      hollow.in_semantic_grid = area(at_flight_height, *outputs_.semantic_grid, T);
    }
  }

  const LabelVocabulary& vocabulary_;
  const RunOutputs& outputs_;
  const MapEvaluationOptions& options_;
  const std::vector<bool> is_of_interest_;  // by label
  const SurfaceLabels surfaces_;
  MapEvaluation result_;
};

}  // namespace

double FlightHeight(const Trajectory& T_world_camera) {
  assert(!T_world_camera.empty());
  std::vector<double> heights_m;
  for (const StampedPose& stamped : T_world_camera) {
    heights_m.push_back(stamped.pose.translation().z());
  }
  const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
  std::nth_element(heights_m.begin(), middle, heights_m.end());
  return *middle;
}

FloorPlanOptions FlightBand(double height_m, double half_width_m) {
  FloorPlanOptions options;
  options.min_height_m = height_m - half_width_m;
  options.max_height_m = height_m + half_width_m;
  return options;
}

MapEvaluation EvaluateMaps(const World& world, const LabelVocabulary& vocabulary,
                           const Trajectory& T_world_camera, const CameraModel& camera,
                           const RunOutputs& outputs, const MapEvaluationOptions& options) {
  Validate(options);
  return Evaluator(world, vocabulary, T_world_camera, camera, outputs, options).Run();
}

}  // namespace semantic_slam
