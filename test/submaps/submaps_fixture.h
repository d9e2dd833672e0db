#pragma once

#include <cmath>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/submaps/occupancy_map.h"
#include "testing/planar_world.h"

// What the tests of submaps share.

namespace semantic_slam {

// A camera that stands level at a place in the plane and looks along its x axis.
inline Rigid3d LevelCamera(const Rigid2d& T_map_scan) {
  Rigid3d T_level_camera = Rigid3d::Identity();
  T_level_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return InSpace(T_map_scan) * T_level_camera;
}

// An image taken there, whose keyframe is at `T_map_keyframe`.
inline TrackedImage ImageAt(const Rigid2d& T_map_scan, KeyframeId keyframe = 0,
                            const Rigid3d& T_map_keyframe = Rigid3d::Identity()) {
  TrackedImage image;
  image.status = TrackingStatus::kTracking;
  image.keyframe_id = keyframe;
  image.T_map_camera = LevelCamera(T_map_scan);
  image.T_keyframe_camera = T_map_keyframe.inverse() * image.T_map_camera;
  return image;
}

inline KeyframeGraph GraphOf(std::uint64_t revision, const std::vector<Rigid3d>& T_map_keyframe,
                             int map_id = 0) {
  KeyframeGraph graph;
  graph.map_id = map_id;
  graph.revision = revision;
  for (std::size_t i = 0; i < T_map_keyframe.size(); ++i) {
    KeyframeNode node;
    node.id = static_cast<KeyframeId>(i);
    node.T_map_keyframe = T_map_keyframe[i];
    graph.keyframes.push_back(node);
  }
  return graph;
}

inline PlanarScan DepthLikeScan(const PlanarWorld& world, const Rigid2d& T_world_scan,
                                Stamp stamp = Stamp{1}) {
  return world.Scan(T_world_scan, M_PI / 3, 120, 8.0, stamp);
}

inline std::int8_t CellAt(const OccupancyMap& map, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d cell = (point_m - map.origin_m) / map.resolution_m;
  const int x = static_cast<int>(std::floor(cell.x())), y = static_cast<int>(std::floor(cell.y()));
  if (x < 0 || y < 0 || x >= map.width || y >= map.height) return OccupancyMap::kUnknown;
  return map.cells[static_cast<std::size_t>(y) * map.width + x];
}

// Cells that are at least 65 % occupied.
struct OccupiedCells {
  int count = 0;
  int far = 0;  // of them, those whose centre is farther from where it should be than the tolerance
};

template <typename Distance>
OccupiedCells CountOccupied(const OccupancyMap& map, double tolerance_m, Distance&& distance_m) {
  OccupiedCells occupied;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (map.cells[static_cast<std::size_t>(y) * map.width + x] < 65) continue;
      const Eigen::Vector2d centre_m =
          map.origin_m + map.resolution_m * Eigen::Vector2d(x + 0.5, y + 0.5);
      ++occupied.count;
      if (distance_m(centre_m) > tolerance_m) ++occupied.far;
    }
  }
  return occupied;
}

}  // namespace semantic_slam
