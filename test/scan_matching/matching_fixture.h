#pragma once

#include <cmath>

#include "semantic_slam/scan_matching/scan_inserter.h"
#include "testing/planar_world.h"

// What the tests of the matchers share.

namespace semantic_slam {

inline PlanarScan LaserScan(const PlanarWorld& world, const Rigid2d& T_world_scan) {
  return world.Scan(T_world_scan, M_PI, 360, 10.0);
}

// A grid of the world, whose frame is the world's, from scans taken around the origin.
inline ProbabilityGrid GridOf(const PlanarWorld& world) {
  ProbabilityGrid grid(0.05);
  const ScanInserter inserter;
  for (int i = 0; i < 24; ++i) {
    const Rigid2d T = MakeRigid2d({0.02 * i - 0.2, 0.01 * i - 0.1}, 2.0 * M_PI * i / 12);
    inserter.Insert(LaserScan(world, T), T, grid);
  }
  return grid;
}

inline double DistanceBetween(const Rigid2d& a, const Rigid2d& b) {
  return (a.translation() - b.translation()).norm();
}

inline double AngleBetween(const Rigid2d& a, const Rigid2d& b) {
  return std::abs(Yaw(a.inverse() * b));
}

}  // namespace semantic_slam
