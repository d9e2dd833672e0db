#include "semantic_slam/ground_truth/floor_plan_truth.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/ground_truth/column_crossings.h"
#include "semantic_slam/ground_truth/surface_points.h"

namespace semantic_slam {
namespace {

constexpr double kFloorM = 0.05;    // how far from z = 0 the building's floor may be
constexpr double kRounding = 1e-3;  // of a cell, that bounds may be over its border
constexpr std::int8_t kFree = 0;
constexpr std::int8_t kOccupied = 100;

OccupancyMap UnknownPlan(const World& world, const FloorPlanOptions& options) {
  OccupancyMap plan;
  plan.resolution_m = options.resolution_m;
  if (world.bounds_m.isEmpty()) return plan;
  const Eigen::Array2d low_m = world.bounds_m.min().head<2>().array() - options.margin_m;
  const Eigen::Array2d high_m = world.bounds_m.max().head<2>().array() + options.margin_m;
  const Eigen::Array2d low = (low_m / options.resolution_m + kRounding).floor();
  const Eigen::Array2d high = (high_m / options.resolution_m - kRounding).ceil();
  plan.origin_m = options.resolution_m * low.matrix();
  plan.width = static_cast<int>(high.x() - low.x());
  plan.height = static_cast<int>(high.y() - low.y());
  plan.cells.assign(static_cast<std::size_t>(plan.width) * plan.height, OccupancyMap::kUnknown);
  return plan;
}

// Fills a plan in, surface by surface.
class PlanPainter {
 public:
  PlanPainter(const FloorPlanOptions& options, OccupancyMap& plan)
      : options_(options), plan_(plan), lattice_{plan.resolution_m, plan.origin_m} {}

  void AddFloor(const Mesh& mesh, const Rigid3d& T_world_mesh) {
    for (const Crossing& crossing : CrossColumns(mesh, T_world_mesh, lattice_)) {
      if (crossing.faces_up && std::abs(crossing.z_m) <= kFloorM) Set(crossing.cell, kFree);
    }
  }

  void AddObstacle(const Mesh& mesh, const Rigid3d& T_world_mesh) {
    for (const SolidPart& part : SolidParts(CrossColumns(mesh, T_world_mesh, lattice_))) {
      if (part.low_m <= options_.max_height_m && part.high_m >= options_.min_height_m) {
        Set(part.cell, kOccupied);
      }
    }
    // Solids that are thinner than a cell, and sheets.
    ForEachSurfacePoint(mesh, T_world_mesh, 0.5 * plan_.resolution_m,
                        [this](const Eigen::Vector3d& point) {
                          if (IsInBand(point.z())) Set(CellOf(point), kOccupied);
                        });
  }

 private:
  bool IsInBand(double z_m) const {
    return z_m >= options_.min_height_m && z_m <= options_.max_height_m;
  }

  cv::Point CellOf(const Eigen::Vector3d& point) const {
    const Eigen::Vector2d cell = (point.head<2>() - plan_.origin_m) / plan_.resolution_m;
    return {static_cast<int>(std::floor(cell.x())), static_cast<int>(std::floor(cell.y()))};
  }

  void Set(cv::Point cell, std::int8_t value) {
    if (!cv::Rect(0, 0, plan_.width, plan_.height).contains(cell)) return;
    plan_.cells[static_cast<std::size_t>(cell.y) * plan_.width + cell.x] = value;
  }

  const FloorPlanOptions& options_;
  OccupancyMap& plan_;
  const CellLattice lattice_;
};

// Makes free space that is enclosed in something occupied.
void FillEnclosures(double max_enclosed_m2, OccupancyMap& plan) {
  if (plan.cells.empty()) return;
  const cv::Mat cells(plan.height, plan.width, CV_8SC1, plan.cells.data());
  cv::Mat regions, statistics, centroids;
  const int count =
      cv::connectedComponentsWithStats(cells == kFree, regions, statistics, centroids, 4);
  const double cell_m2 = plan.resolution_m * plan.resolution_m;
  std::vector<bool> is_enclosed(count, false);
  for (int i = 1; i < count; ++i) {
    is_enclosed[i] = statistics.at<int>(i, cv::CC_STAT_AREA) * cell_m2 <= max_enclosed_m2;
  }
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    if (is_enclosed[regions.ptr<int>()[i]]) plan.cells[i] = kOccupied;
  }
}

}  // namespace

OccupancyMap TrueFloorPlan(const World& world, const FloorPlanOptions& options) {
  Validate(options);
  OccupancyMap plan = UnknownPlan(world, options);
  PlanPainter painter(options, plan);
  for (const WorldObject& object : world.objects) {
    if (!object.is_structure) continue;
    for (const Surface& surface : object.surfaces) {
      painter.AddFloor(surface.mesh, object.T_world_object);
    }
  }
  for (const WorldObject& object : world.objects) {
    if (object.IsMoving()) continue;
    for (const Surface& surface : object.surfaces) {
      painter.AddObstacle(surface.mesh, object.T_world_object);
    }
  }
  FillEnclosures(options.max_enclosed_m2, plan);
  return plan;
}

}  // namespace semantic_slam
