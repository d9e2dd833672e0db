#pragma once

#include <vector>

#include <Eigen/Core>

#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/scan/planar_scan.h"

namespace semantic_slam {

struct WallSegment {
  Eigen::Vector2d begin_m;
  Eigen::Vector2d end_m;
};

// Walls in a plane, and what an exact scanner sees of them.
class PlanarWorld {
 public:
  explicit PlanarWorld(std::vector<WallSegment> walls) : walls_(std::move(walls)) {}

  // Distance [m] to the first wall from a point along a unit direction; infinite if there is none.
  double Distance(const Eigen::Vector2d& from_m, const Eigen::Vector2d& direction) const;

  // Distance [m] to the nearest wall in any direction.
  double Clearance(const Eigen::Vector2d& from_m) const;

  // `beams` over `field_of_view_rad` about x; a beam that meets no wall is free to the maximum
  // range.
  PlanarScan Scan(const Rigid2d& T_world_scan, double field_of_view_rad, int beams,
                  double max_range_m, Stamp stamp = Stamp{1}) const;

 private:
  std::vector<WallSegment> walls_;
};

// A room 6 m by 4 m about the origin with a pillar and a niche, so that it looks different from
// everywhere.
PlanarWorld PlanarRoom();

// Two parallel walls, 2 m apart, along x, with no end in sight.
PlanarWorld PlanarCorridor();

}  // namespace semantic_slam
