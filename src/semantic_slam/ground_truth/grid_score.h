#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/plane_projection/convex_polygon.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

struct GridScoreOptions {
  int occupied_percent = 65;   // a cell of so much or more is occupied,
  int free_percent = 25;       // of less than that free
  double tolerance_m = 0.075;  // how far beside it a cell's like may be: a cell and its diagonal

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("occupied_percent", self.occupied_percent, 1, 100);
    visit("free_percent", self.free_percent, 0, self.occupied_percent);
    visit("tolerance_m", self.tolerance_m, 0.0, 1.0);
  }
};

// How many of some things are right; share() is 1 if there are none.
struct CellCount {
  std::size_t cells = 0;
  std::size_t right = 0;

  double share() const;
};

// How far a grid tells the truth within the building. A cell is right if the other grid has one of
// its kind within the tolerance.
struct GridScore {
  CellCount free_precision;      // of the cells that the estimate calls free
  CellCount occupied_precision;  // of those it calls occupied
  CellCount free_recall;         // of the truly free cells where the estimate knows something
  CellCount occupied_recall;     // the same of those truly occupied that border on free ones
};

// `estimate` lies at T_truth_estimate. Throws ConfigError if an option is out of range.
GridScore ScoreGrid(const OccupancyMap& truth, const OccupancyMap& estimate,
                    const Rigid2d& T_truth_estimate, const GridScoreOptions& options = {});

// Of the area of polygons in the frame of the truth, sampled every `spacing_m`: where the estimate
// knows something or not, how much it calls occupied.
CellCount OccupiedArea(const std::vector<ConvexPolygon>& polygons_m, const OccupancyMap& estimate,
                       const Rigid2d& T_truth_estimate, double spacing_m,
                       const GridScoreOptions& options = {});

// How occupied the cell at a point is; kUnknown outside of the map.
std::int8_t PercentAt(const OccupancyMap& map, const Eigen::Vector2d& point_m);

// Makes the cells whose centres are in the polygon occupied.
void FillPolygon(const ConvexPolygon& polygon_m, OccupancyMap& map);

}  // namespace semantic_slam
