#pragma once

#include <optional>

#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/scan/planar_scan.h"
#include "semantic_slam/scan_matching/scan_matcher.h"
#include "semantic_slam/submaps/grid_slam_options.h"
#include "semantic_slam/submaps/occupancy_map.h"
#include "semantic_slam/submaps/submap_collection.h"

namespace semantic_slam {

// The local half of 2D SLAM for a laser scanner (Hess et al., ICRA 2016, section IV): odometry says
// about where each scan was taken, matching it to a submap says exactly where. Without loop
// closing, so errors add up over long ways. Of the options it uses all but the scan builder's and
// what is about keyframes. Not thread-safe.
class PlanarSlam {
 public:
  // Throws ConfigError if an option is out of range.
  explicit PlanarSlam(const GridSlamOptions& options);

  // Takes in the next scan, taken at `T_odom_scan` in a frame that drifts. Returns T_map_scan; the
  // map begins at the first scan. A scan that does not fit is where odometry puts it.
  Rigid2d Add(const PlanarScan& scan, const Rigid2d& T_odom_scan);

  // The map so far; without map_id and revision, as no keyframes are behind it.
  OccupancyMap Render() const;

  std::size_t submaps() const { return submaps_.size(); }

 private:
  bool HasMoved() const;

  const GridMapperOptions options_;
  const ScanMatcher matcher_;
  SubmapCollection submaps_;
  Rigid2d T_map_scan_ = Rigid2d::Identity();  // of the last scan
  std::optional<Rigid2d> T_odom_scan_;        // likewise
  std::optional<Rigid2d> T_map_entered_;      // of the last scan that was entered
  Stamp stamp_;                               // likewise
};

}  // namespace semantic_slam
