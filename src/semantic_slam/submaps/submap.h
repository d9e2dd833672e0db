#pragma once

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/scan/planar_scan.h"
#include "semantic_slam/scan_matching/probability_grid.h"
#include "semantic_slam/scan_matching/scan_inserter.h"

namespace semantic_slam {

using SubmapId = int;

// A piece of the floor plan that is taken to be rigid (Hess et al., ICRA 2016, section IV-B): a
// grid, in the level frame of the place where it began, that hangs on a keyframe. Not thread-safe.
class Submap {
 public:
  // `T_keyframe_submap` is the level frame, z up, seen from the keyframe.
  Submap(SubmapId id, double resolution_m, KeyframeId keyframe, const Rigid3d& T_map_keyframe,
         const Rigid3d& T_keyframe_submap);

  SubmapId id() const { return id_; }
  KeyframeId keyframe() const { return keyframe_; }
  const ProbabilityGrid& grid() const { return grid_; }
  int scans() const { return scans_; }

  // Where it lies in the map now, seen from above.
  const Rigid2d& T_map_submap() const { return T_map_submap_; }

  // The farthest that a scan was taken from where the submap began [m], and the largest turn from
  // there [rad]. Hovering does not add to them.
  double distance_m() const { return distance_m_; }
  double turn_rad() const { return turn_rad_; }

  void Insert(const PlanarScan& scan, const Rigid2d& T_map_scan, const ScanInserter& inserter);

  // Moves with its keyframe, which is at `T_map_keyframe` now. Does nothing, and returns false, if
  // no point within `reach_m` moves by more than `threshold_m`.
  bool Follow(const Rigid3d& T_map_keyframe, double reach_m, double threshold_m);

 private:
  const SubmapId id_;
  const KeyframeId keyframe_;
  const Rigid3d T_keyframe_submap_;
  Rigid3d T_map_keyframe_;
  Rigid2d T_map_submap_;
  ProbabilityGrid grid_;
  int scans_ = 0;
  double distance_m_ = 0.0;
  double turn_rad_ = 0.0;
};

}  // namespace semantic_slam
