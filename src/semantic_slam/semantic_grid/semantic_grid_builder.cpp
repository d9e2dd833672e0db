#include "semantic_slam/semantic_grid/semantic_grid_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"

namespace semantic_slam {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

void CheckInput(const OccupancyMap& map, const ObjectMap& objects,
                const LabelVocabulary& vocabulary) {
  if (map.width < 0 || map.height < 0 || !(map.resolution_m > 0.0) ||
      map.cells.size() != static_cast<std::size_t>(map.width) * map.height) {
    throw InputError("semantic grid: an occupancy map of " + std::to_string(map.width) + " x " +
                     std::to_string(map.height) + " has " + std::to_string(map.cells.size()) +
                     " cells");
  }
  if (objects.objects.empty()) return;
  CheckLabelSet("semantic grid: objects", objects.vocabulary_hash, vocabulary);
}

// The box as seen from above.
ConvexPolygon BoxOutline(const MapObject& object) {
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    corners.push_back((object.T_map_box * corner.cwiseProduct(object.box_size_m)).head<2>());
  }
  return ConvexHull(std::move(corners));
}

ConvexPolygon Outline(const MapObject& object) {
  const ConvexPolygon outline = ConvexHull(object.footprint_m);
  return outline.empty() ? BoxOutline(object) : outline;
}

Eigen::Vector2d PositionSigma(const MapObject& object, double max_sigma_m) {
  const Eigen::Vector2d variance = object.position_covariance_m2.diagonal().head<2>();
  return variance.cwiseMax(0.0).cwiseSqrt().cwiseMin(max_sigma_m);
}

// Far from where cells could not be counted in an int.
bool IsNear(const ConvexPolygon& outline, const Eigen::Vector2d& origin_m, double reach_m) {
  return std::all_of(outline.begin(), outline.end(), [&](const Eigen::Vector2d& corner) {
    return (corner - origin_m).cwiseAbs().maxCoeff() <= reach_m;
  });
}

CellLattice LatticeOf(const OccupancyMap& map, double resolution_m) {
  return map.cells.empty() ? CellLattice{resolution_m, Eigen::Vector2d::Zero()}
                           : CellLattice{map.resolution_m, map.origin_m};
}

}  // namespace

SemanticGridBuilder::SemanticGridBuilder(const SemanticGridOptions& options,
                                         const SemanticCostOptions& cost_options,
                                         LabelVocabulary vocabulary)
    : options_(Validated(options)),
      costs_(cost_options),
      height_probability_(cost_options.free_probability),
      vocabulary_(std::move(vocabulary)) {}

SemanticCells SemanticGridBuilder::Build(const OccupancyMap& map, const ObjectMap& objects) const {
  CheckInput(map, objects, vocabulary_);
  cv::Rect area(0, 0, map.width, map.height);
  const std::vector<PlacedObject> placed = Place(map, objects, area);
  SemanticCells cells = Unfilled(map, objects, area);
  AddOccupancy(map, area, cells);
  for (const PlacedObject& object : placed) AddObject(object, cells);
  FillClasses(placed, vocabulary_, options_.min_class_probability, cells);
  return cells;
}

// Grows `area`, which counts in cells of the map, by what the objects cover.
std::vector<PlacedObject> SemanticGridBuilder::Place(const OccupancyMap& map,
                                                     const ObjectMap& objects,
                                                     cv::Rect& area) const {
  const CellLattice lattice = LatticeOf(map, options_.resolution_m);
  const double map_side_m = std::max(map.width, map.height) * lattice.resolution_m;
  const double max_side_m = std::max(options_.max_side_m, map_side_m);
  std::vector<PlacedObject> placed;
  for (const MapObject& object : objects.objects) {
    const ConvexPolygon outline = Outline(object);
    if (outline.empty() || !IsNear(outline, lattice.origin_m, max_side_m)) continue;
    PresencePatch patch =
        RasterisePresence(outline, PositionSigma(object, options_.max_position_sigma_m), lattice);
    const cv::Rect grown = area | patch.cells;
    if (std::max(grown.width, grown.height) * lattice.resolution_m > max_side_m) continue;
    area = grown;
    placed.push_back({&object, std::move(patch)});
  }
  for (PlacedObject& object : placed) object.patch.cells -= area.tl();
  return placed;
}

SemanticCells SemanticGridBuilder::Unfilled(const OccupancyMap& map, const ObjectMap& objects,
                                            const cv::Rect& area) const {
  const CellLattice lattice = LatticeOf(map, options_.resolution_m);
  SemanticCells cells;
  cells.stamp = std::max(map.stamp, objects.stamp);
  cells.map_id = objects.objects.empty() ? map.map_id : objects.map_id;
  cells.revision = objects.objects.empty() ? map.revision : objects.revision;
  cells.vocabulary_hash = vocabulary_.hash();
  cells.resolution_m = lattice.resolution_m;
  cells.origin_m = lattice.origin_m + lattice.resolution_m * Eigen::Vector2d(area.x, area.y);
  cells.width = area.width;
  cells.height = area.height;
  const std::size_t count = static_cast<std::size_t>(area.width) * area.height;
  cells.cost.assign(count, SemanticCells::kUnknown);
  cells.classes_per_cell = options_.classes_per_cell;
  cells.labels.assign(count * cells.classes_per_cell, kUnknownLabel);
  cells.probabilities.assign(count * cells.classes_per_cell, 0);
  cells.min_height_m.assign(count, kNan);
  cells.max_height_m.assign(count, kNan);
  return cells;
}

void SemanticGridBuilder::AddOccupancy(const OccupancyMap& map, const cv::Rect& area,
                                       SemanticCells& cells) const {
  for (int y = 0; y < map.height; ++y) {
    const auto* in = map.cells.data() + static_cast<std::size_t>(y) * map.width;
    auto* out = cells.cost.data() + static_cast<std::size_t>(y - area.y) * cells.width - area.x;
    for (int x = 0; x < map.width; ++x) out[x] = costs_.OfOccupancy(in[x]);
  }
}

void SemanticGridBuilder::AddObject(const PlacedObject& placed, SemanticCells& cells) const {
  const MapObject& object = *placed.object;
  const double full_cost = costs_.OfObject(object, vocabulary_);
  const cv::Rect& patch = placed.patch.cells;
  for (int v = 0; v < patch.height; ++v) {
    const auto* presence = placed.patch.probability.ptr<float>(v);
    const std::size_t first = static_cast<std::size_t>(patch.y + v) * cells.width + patch.x;
    for (int u = 0; u < patch.width; ++u) {
      std::uint8_t& cost = cells.cost[first + u];
      cost = costs_.Combined(cost, presence[u], full_cost);
      if (presence[u] <= height_probability_) continue;
      // fmin and fmax pass over the NaN of a cell where nothing was seen.
      float& lowest = cells.min_height_m[first + u];
      float& highest = cells.max_height_m[first + u];
      lowest = std::fmin(lowest, static_cast<float>(object.min_height_m));
      highest = std::fmax(highest, static_cast<float>(object.max_height_m));
    }
  }
}

}  // namespace semantic_slam
