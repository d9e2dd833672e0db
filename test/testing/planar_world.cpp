#include "testing/planar_world.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace semantic_slam {
namespace {

// The walls of a polygon, closed.
void AddPolygon(const std::vector<Eigen::Vector2d>& corners, std::vector<WallSegment>& walls) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    walls.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
}

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

double PlanarWorld::Distance(const Eigen::Vector2d& from_m,
                             const Eigen::Vector2d& direction) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const WallSegment& wall : walls_) {
    const Eigen::Vector2d along = wall.end_m - wall.begin_m, to_wall = wall.begin_m - from_m;
    const double cross = Cross(direction, along);
    if (cross == 0.0) continue;  // parallel
    const double distance_m = Cross(to_wall, along) / cross;
    const double share = Cross(to_wall, direction) / cross;
    if (distance_m > 0.0 && share >= 0.0 && share <= 1.0) {
      nearest_m = std::min(nearest_m, distance_m);
    }
  }
  return nearest_m;
}

double PlanarWorld::Clearance(const Eigen::Vector2d& from_m) const {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const WallSegment& wall : walls_) {
    const Eigen::Vector2d along = wall.end_m - wall.begin_m;
    const double share =
        std::clamp((from_m - wall.begin_m).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest_m = std::min(nearest_m, (from_m - wall.begin_m - share * along).norm());
  }
  return nearest_m;
}

PlanarScan PlanarWorld::Scan(const Rigid2d& T_world_scan, double field_of_view_rad, int beams,
                             double max_range_m, Stamp stamp) const {
  PlanarScan scan;
  scan.stamp = stamp;
  scan.bearing_step_rad = field_of_view_rad / beams;
  scan.first_bearing_rad = -0.5 * scan.bearing_step_rad * (beams - 1);
  scan.max_range_m = max_range_m;
  scan.beams.resize(beams);
  for (int i = 0; i < beams; ++i) {
    const double distance_m =
        Distance(T_world_scan.translation(), T_world_scan.linear() * scan.Direction(i));
    ScanBeam& beam = scan.beams[i];
    if (distance_m < max_range_m) beam.hit_m = static_cast<float>(distance_m);
    beam.free_to_m = static_cast<float>(std::min(distance_m, max_range_m));
  }
  return scan;
}

PlanarWorld PlanarRoom() {
  std::vector<WallSegment> walls;
  AddPolygon({{-3.0, -2.0},
              {3.0, -2.0},
              {3.0, 0.5},
              {3.5, 0.5},
              {3.5, 1.2},
              {3.0, 1.2},
              {3.0, 2.0},
              {-3.0, 2.0}},
             walls);
  AddPolygon({{1.0, 0.8}, {1.4, 0.9}, {1.3, 1.3}, {0.9, 1.2}}, walls);
  return PlanarWorld(std::move(walls));
}

PlanarWorld PlanarCorridor() {
  return PlanarWorld({{{-1000.0, -1.0}, {1000.0, -1.0}}, {{-1000.0, 1.0}, {1000.0, 1.0}}});
}

}  // namespace semantic_slam
