#include "semantic_slam/submaps/submap_merging.h"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace semantic_slam {
namespace {

// The cells of the map that a submap may know.
CellBox BoxInMap(const Submap& submap, const CellBox& known) {
  const ProbabilityGrid& grid = submap.grid();
  CellBox box;
  for (const int x : {known.low.x(), known.high.x()}) {
    for (const int y : {known.low.y(), known.high.y()}) {
      const Eigen::Vector2d corner_m = grid.resolution_m() * Eigen::Vector2d(x, y);
      box.Include(grid.CellAt(submap.T_map_submap() * corner_m));
    }
  }
  return box;
}

// Calls visit(cell, evidence) for every cell of the map that the submap knows: the evidence of its
// cell in which the map's cell has its centre.
template <typename Visit>
void ForEachKnownCell(const Submap& submap, const CellBox& box, Visit&& visit) {
  const ProbabilityGrid& grid = submap.grid();
  const Rigid2d T_submap_map = submap.T_map_submap().inverse();
  const Eigen::Vector2d along_x_m = T_submap_map.linear().col(0) * grid.resolution_m();
  for (int y = box.low.y(); y < box.high.y(); ++y) {
    Eigen::Vector2d centre_m = T_submap_map * grid.CentreOf({box.low.x(), y});
    for (int x = box.low.x(); x < box.high.x(); ++x, centre_m += along_x_m) {
      const ProbabilityGrid::LogOdds evidence = grid.At(grid.CellAt(centre_m));
      if (evidence != ProbabilityGrid::kUnknown) visit(CellIndex(x, y), evidence);
    }
  }
}

// Cells of the map, counted.
class CellCounts {
 public:
  explicit CellCounts(const CellBox& box)
      : box_(box), counts_(static_cast<std::size_t>(box.width()) * box.height()) {}

  std::uint16_t& At(const CellIndex& cell) {
    return counts_[static_cast<std::size_t>(cell.y() - box_.low.y()) * box_.width() +
                   (cell.x() - box_.low.x())];
  }

 private:
  const CellBox box_;
  std::vector<std::uint16_t> counts_;
};

void Include(const CellBox& added, CellBox& box) {
  if (added.empty()) return;
  box.Include(added.low);
  box.Include((added.high.array() - 1).matrix());
}

OccupancyMap ToOccupancyMap(const ProbabilityGrid& grid) {
  const CellBox box = grid.KnownBox();
  OccupancyMap map;
  map.resolution_m = grid.resolution_m();
  map.origin_m = grid.resolution_m() * box.low.cast<double>();
  map.width = box.width();
  map.height = box.height();
  map.cells.reserve(static_cast<std::size_t>(map.width) * map.height);
  for (int y = box.low.y(); y < box.high.y(); ++y) {
    for (int x = box.low.x(); x < box.high.x(); ++x) {
      const ProbabilityGrid::LogOdds evidence = grid.At({x, y});
      const double probability = ProbabilityGrid::ToProbability(evidence);
      map.cells.push_back(evidence == ProbabilityGrid::kUnknown
                              ? OccupancyMap::kUnknown
                              : static_cast<std::int8_t>(std::lround(100.0 * probability)));
    }
  }
  return map;
}

}  // namespace

OccupancyMap MergeSubmaps(const std::vector<const Submap*>& submaps, double resolution_m) {
  ProbabilityGrid merged(resolution_m);
  for (const Submap* submap : submaps) {
    const CellBox known = submap->grid().KnownBox();
    if (known.empty()) continue;
    const CellBox box = BoxInMap(*submap, known);
    merged.Grow(box);
    ForEachKnownCell(*submap, box, [&](const CellIndex& cell, ProbabilityGrid::LogOdds evidence) {
      merged.Add(cell, evidence);
    });
  }
  return ToOccupancyMap(merged);
}

std::size_t LeastMissed(const std::vector<const Submap*>& submaps) {
  assert(!submaps.empty());
  std::vector<CellBox> boxes;
  CellBox all;
  for (const Submap* submap : submaps) {
    const CellBox known = submap->grid().KnownBox();
    boxes.push_back(known.empty() ? CellBox() : BoxInMap(*submap, known));
    Include(boxes.back(), all);
  }
  CellCounts counts(all);
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    ForEachKnownCell(*submaps[i], boxes[i],
                     [&](const CellIndex& cell, auto) { ++counts.At(cell); });
  }
  std::size_t least = 0, fewest = SIZE_MAX;
  for (std::size_t i = 0; i < submaps.size(); ++i) {
    std::size_t alone = 0;
    ForEachKnownCell(*submaps[i], boxes[i],
                     [&](const CellIndex& cell, auto) { alone += counts.At(cell) == 1; });
    if (alone < fewest) least = i, fewest = alone;
  }
  return least;
}

}  // namespace semantic_slam
