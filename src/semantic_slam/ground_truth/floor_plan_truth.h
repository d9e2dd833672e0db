#pragma once

#include "semantic_slam/common/options.h"
#include "semantic_slam/submaps/occupancy_map.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

struct FloorPlanOptions {
  double resolution_m = 0.05;
  // What reaches into this band of heights is an obstacle. The default is all that stands about,
  // but for rugs and skirting boards, and under the lintels of doors.
  double min_height_m = 0.1;
  double max_height_m = 1.9;
  double margin_m = 0.5;  // around the building
  // Free space with no way out of this size or less is the inside of a cupboard.
  double max_enclosed_m2 = 2.0;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("resolution_m", self.resolution_m, 0.005, 1.0);
    visit("min_height_m", self.min_height_m, -100.0, self.max_height_m);
    visit("max_height_m", self.max_height_m, -100.0, 100.0);
    visit("margin_m", self.margin_m, 0.0, 10.0);
    visit("max_enclosed_m2", self.max_enclosed_m2, 0.0, 100.0);
  }
};

// The true floor plan of what does not move: a cell is occupied (100) if a surface or a solid's
// inside reaches into its column within the band, free (0) if not and the building's floor is
// below, else outside of the building and unknown. In the world frame; the origin is a multiple of
// the resolution. Throws ConfigError if an option is out of range.
OccupancyMap TrueFloorPlan(const World& world, const FloorPlanOptions& options);

}  // namespace semantic_slam
