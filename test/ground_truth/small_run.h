#pragma once

#include <cmath>

#include "ground_truth/small_world.h"
#include "semantic_slam/ground_truth/floor_plan_truth.h"
#include "semantic_slam/ground_truth/map_evaluation.h"
#include "semantic_slam/ground_truth/object_truth.h"
#include "semantic_slam/ground_truth/run_outputs.h"

namespace semantic_slam {

// A camera that looks level to a direction of the floor plan, at `seconds`.
inline StampedPose Looking(double seconds, const Eigen::Vector3d& position, double yaw_rad) {
  Rigid3d T_level_camera = Rigid3d::Identity();
  T_level_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Stamp::FromSeconds(seconds), Eigen::Translation3d(position) *
                                           Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                                           T_level_camera};
}

// Around SmallWorld()'s table at a height of 1.2 m, with a look at its middle.
inline Trajectory SmallTour() {
  Trajectory tour;
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * M_PI * i / 40;
    const Eigen::Vector3d position(2.0 + 1.5 * std::cos(angle), 1.5 + 1.2 * std::sin(angle), 1.2);
    tour.push_back(Looking(0.5 * i, position, angle + M_PI));
  }
  return tour;
}

// Where the map of that tour lies: turned and shifted.
inline Rigid3d SmallMapPose() {
  return Eigen::Translation3d(3.5, 1.5, 1.2) *
         Rigid3d(Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()));
}

// Voxels of SmallWorld()'s table top in a map at T_world_map.
inline std::unique_ptr<SemanticOcTree> TableTop(const Rigid3d& T_world_map) {
  auto tree = std::make_unique<SemanticOcTree>(0.05);
  LabelDistribution distribution;
  distribution.labels[0] = kTable;
  distribution.probabilities[0] = 0.8f;
  distribution.observations = 3;
  const Rigid3d T_map_world = T_world_map.inverse();
  for (double x = 1.425; x < 2.6; x += 0.05) {
    for (double y = 1.125; y < 1.9; y += 0.05) {
      const Eigen::Vector3d p = T_map_world * Eigen::Vector3d(x, y, 0.73);
      tree->setNodeValue(p.x(), p.y(), p.z(), 2.0f, true)->SetLabels(CompactLabels(distribution));
    }
  }
  tree->updateInnerOccupancy();
  return tree;
}

// SmallVocabulary() has none of the classes that are ignored by default.
inline MapEvaluationOptions SmallEvaluation() {
  MapEvaluationOptions options;
  options.ignored_classes = "unknown";
  return options;
}

// What a perfect run in SmallWorld() would leave. `T_world_map` is level, and turned by a multiple
// of 90 degrees.
inline RunOutputs PerfectRun(const Rigid3d& T_world_map = SmallMapPose()) {
  RunOutputs run;
  const Rigid3d T_map_world = T_world_map.inverse();
  for (const StampedPose& stamped : SmallTour()) {
    run.trajectory.push_back({stamped.stamp, T_map_world * stamped.pose});
  }
  run.tree = TableTop(T_world_map);
  run.objects = TrueObjects(SmallWorld(), SmallVocabulary());
  for (MapObject& object : run.objects->objects) object = InWorld(object, T_map_world);
  World moved = SmallWorld();
  moved.bounds_m = Eigen::AlignedBox3d();
  for (WorldObject& object : moved.objects) {
    // The floor plan is one of heights over the floor, the map's z is not.
    object.T_world_object = Eigen::Translation3d(0.0, 0.0, T_world_map.translation().z()) *
                            T_map_world * object.T_world_object;
    for (const Surface& surface : object.surfaces) {
      for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
        moved.bounds_m.extend(object.T_world_object * p.cast<double>());
      }
    }
  }
  run.grid = TrueFloorPlan(moved, FlightBand(1.2, 0.2));
  run.semantic_grid = run.grid;
  return run;
}

}  // namespace semantic_slam
