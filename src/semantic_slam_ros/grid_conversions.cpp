#include "semantic_slam_ros/grid_conversions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam/semantic_grid/semantic_costs.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

using semantic_slam::InputError;
using semantic_slam::LabelVocabulary;
using semantic_slam::OccupancyMap;
using semantic_slam::SemanticCells;
using GridMsg = semantic_slam::SemanticGrid;

static_assert(GridMsg::COST_FREE == SemanticCells::kFree);
static_assert(GridMsg::COST_INSCRIBED == SemanticCells::kInscribed);
static_assert(GridMsg::COST_LETHAL == SemanticCells::kLethal);
static_assert(GridMsg::COST_UNKNOWN == SemanticCells::kUnknown);

namespace {

// 2 km at 5 cm; more is a malformed message, not a building.
constexpr std::uint32_t kMaxSideCells = 40000;

// `Grid` is OccupancyMap or SemanticCells.
template <typename Grid>
nav_msgs::MapMetaData ToMetaData(const Grid& grid) {
  nav_msgs::MapMetaData info;
  info.map_load_time = ToRos(grid.stamp);
  info.resolution = static_cast<float>(grid.resolution_m);
  info.width = static_cast<std::uint32_t>(grid.width);
  info.height = static_cast<std::uint32_t>(grid.height);
  info.origin.position.x = grid.origin_m.x();
  info.origin.position.y = grid.origin_m.y();
  info.origin.orientation.w = 1.0;
  return info;
}

// The resolution as it was meant: 0.05, not the nearest float.
double ToResolution(float resolution_m) {
  constexpr double kMicrometresPerMetre = 1e6;
  return std::round(resolution_m * kMicrometresPerMetre) / kMicrometresPerMetre;
}

template <typename Grid>
void ReadMetaData(const nav_msgs::MapMetaData& info, const std::string& who, Grid& grid) {
  constexpr double kLevel = 1e-6;
  if (!std::isfinite(info.resolution) || !(info.resolution > 1e-6f)) {
    throw InputError(who + ": resolution is " + std::to_string(info.resolution));
  }
  if (info.width > kMaxSideCells || info.height > kMaxSideCells) {
    throw InputError(who + ": size is " + std::to_string(info.width) + " x " +
                     std::to_string(info.height) + " cells");
  }
  const geometry_msgs::Quaternion& q = info.origin.orientation;
  // All zero is what careless writers send for "not turned".
  if (!(std::abs(q.x) < kLevel && std::abs(q.y) < kLevel && std::abs(q.z) < kLevel)) {
    throw InputError(who + ": origin is turned, which is not supported");
  }
  grid.resolution_m = ToResolution(info.resolution);
  grid.width = static_cast<int>(info.width);
  grid.height = static_cast<int>(info.height);
  grid.origin_m = {info.origin.position.x, info.origin.position.y};
  if (!grid.origin_m.allFinite()) throw InputError(who + ": origin is not finite");
}

void CheckSize(std::size_t size, std::size_t expected, const std::string& what) {
  if (size == expected) return;
  throw InputError(what + " has " + std::to_string(size) + " elements, expected " +
                   std::to_string(expected));
}

void CheckSizes(const GridMsg& msg) {
  const std::size_t cells = std::size_t{msg.info.width} * msg.info.height;
  CheckSize(msg.cost.size(), cells, "semantic grid: cost");
  CheckSize(msg.labels.size(), cells * msg.classes_per_cell, "semantic grid: labels");
  CheckSize(msg.probabilities.size(), cells * msg.classes_per_cell, "semantic grid: probabilities");
  CheckSize(msg.min_height.size(), cells, "semantic grid: min_height");
  CheckSize(msg.max_height.size(), cells, "semantic grid: max_height");
}

void CheckLabels(const GridMsg& msg, const LabelVocabulary& vocabulary) {
  semantic_slam::CheckLabelSet("semantic grid", msg.label_set_hash, vocabulary);
  for (const semantic_slam::LabelId label : msg.labels) {
    semantic_slam::CheckLabel("semantic grid", label, vocabulary);
  }
}

}  // namespace

nav_msgs::OccupancyGrid ToOccupancyGrid(const OccupancyMap& map, const std::string& map_frame) {
  nav_msgs::OccupancyGrid msg;
  msg.header = MakeHeader(map.stamp, map_frame);
  msg.info = ToMetaData(map);
  msg.data = map.cells;
  return msg;
}

OccupancyMap ToOccupancyMap(const nav_msgs::OccupancyGrid& msg) {
  OccupancyMap map;
  map.stamp = ToStamp(msg.header.stamp);
  ReadMetaData(msg.info, "map", map);
  CheckSize(msg.data.size(), std::size_t{msg.info.width} * msg.info.height, "map: data");
  for (const std::int8_t value : msg.data) {
    if (value >= OccupancyMap::kUnknown && value <= 100) continue;
    throw InputError("map: a cell is " + std::to_string(value) + ", expected -1 to 100");
  }
  map.cells = msg.data;
  return map;
}

GridMsg ToSemanticGrid(const SemanticCells& cells, const std::string& map_frame) {
  GridMsg msg;
  msg.header = MakeHeader(cells.stamp, map_frame);
  msg.map_id = cells.map_id;
  msg.revision = cells.revision;
  msg.label_set_hash = cells.vocabulary_hash;
  msg.info = ToMetaData(cells);
  msg.cost = cells.cost;
  msg.classes_per_cell = static_cast<std::uint8_t>(cells.classes_per_cell);
  msg.labels = cells.labels;
  msg.probabilities = cells.probabilities;
  msg.min_height = cells.min_height_m;
  msg.max_height = cells.max_height_m;
  return msg;
}

SemanticCells ToSemanticCells(const GridMsg& msg, const LabelVocabulary& vocabulary) {
  SemanticCells cells;
  cells.stamp = ToStamp(msg.header.stamp);
  cells.map_id = msg.map_id;
  cells.revision = msg.revision;
  cells.vocabulary_hash = msg.label_set_hash;
  ReadMetaData(msg.info, "semantic grid", cells);
  CheckSizes(msg);
  CheckLabels(msg, vocabulary);
  cells.cost = msg.cost;
  cells.classes_per_cell = msg.classes_per_cell;
  cells.labels = msg.labels;
  cells.probabilities = msg.probabilities;
  cells.min_height_m = msg.min_height;
  cells.max_height_m = msg.max_height;
  return cells;
}

nav_msgs::OccupancyGrid ToOccupancyGrid(const SemanticCells& cells, const std::string& map_frame) {
  nav_msgs::OccupancyGrid msg;
  msg.header = MakeHeader(cells.stamp, map_frame);
  msg.info = ToMetaData(cells);
  msg.data.reserve(cells.cost.size());
  std::transform(cells.cost.begin(), cells.cost.end(), std::back_inserter(msg.data),
                 semantic_slam::ToOccupancyPercent);
  return msg;
}

}  // namespace semantic_slam_ros
