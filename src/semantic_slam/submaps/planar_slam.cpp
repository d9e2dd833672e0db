#include "semantic_slam/submaps/planar_slam.h"

#include <cmath>

namespace semantic_slam {

PlanarSlam::PlanarSlam(const GridSlamOptions& options)
    : options_(Validated(options.grid_mapper)),
      matcher_(options.scan_matcher, options.correlative_matcher, options.ceres_matcher),
      submaps_(options.submaps, options.scan_inserter, options_.max_submaps) {}

Rigid2d PlanarSlam::Add(const PlanarScan& scan, const Rigid2d& T_odom_scan) {
  const Rigid2d moved = T_odom_scan_ ? T_odom_scan_->inverse() * T_odom_scan : Rigid2d::Identity();
  T_odom_scan_ = T_odom_scan;
  T_map_scan_ = submaps_.Match(matcher_, scan, T_map_scan_ * moved);
  if (HasMoved()) {
    submaps_.Insert({scan, T_map_scan_, kNoKeyframe, Rigid3d::Identity(), InSpace(T_map_scan_)});
    T_map_entered_ = T_map_scan_;
    stamp_ = scan.stamp;
  }
  return T_map_scan_;
}

OccupancyMap PlanarSlam::Render() const {
  OccupancyMap map = submaps_.Render();
  map.stamp = stamp_;
  return map;
}

bool PlanarSlam::HasMoved() const {
  if (!T_map_entered_) return true;
  const Rigid2d moved = T_map_entered_->inverse() * T_map_scan_;
  return moved.translation().norm() > options_.min_motion_m ||
         std::abs(Yaw(moved)) > options_.min_turn_deg * M_PI / 180.0;
}

}  // namespace semantic_slam
