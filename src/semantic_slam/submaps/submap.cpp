#include "semantic_slam/submaps/submap.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/common/keyframe_poses.h"

namespace semantic_slam {

Submap::Submap(SubmapId id, double resolution_m, KeyframeId keyframe, const Rigid3d& T_map_keyframe,
               const Rigid3d& T_keyframe_submap)
    : id_(id),
      keyframe_(keyframe),
      T_keyframe_submap_(T_keyframe_submap),
      T_map_keyframe_(T_map_keyframe),
      T_map_submap_(Flattened(T_map_keyframe * T_keyframe_submap)),
      grid_(resolution_m) {}

void Submap::Insert(const PlanarScan& scan, const Rigid2d& T_map_scan,
                    const ScanInserter& inserter) {
  const Rigid2d T_submap_scan = T_map_submap_.inverse() * T_map_scan;
  inserter.Insert(scan, T_submap_scan, grid_);
  ++scans_;
  distance_m_ = std::max(distance_m_, T_submap_scan.translation().norm());
  turn_rad_ = std::max(turn_rad_, std::abs(Yaw(T_submap_scan)));
}

bool Submap::Follow(const Rigid3d& T_map_keyframe, double reach_m, double threshold_m) {
  const Rigid3d before = T_map_keyframe_ * T_keyframe_submap_;
  const Rigid3d after = T_map_keyframe * T_keyframe_submap_;
  if (Displacement(before, after, reach_m) <= threshold_m) return false;
  T_map_keyframe_ = T_map_keyframe;
  T_map_submap_ = Flattened(after);
  return true;
}

}  // namespace semantic_slam
