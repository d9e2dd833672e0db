#include "semantic_slam/control/speed_limits.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr double kStraightRad = 1e-3;

// Of the waypoint `before` the corner, `at` it and `after` it.
Passage PlanPassage(const Waypoint& before, const Waypoint& at, const Waypoint& after,
                    const CornerLimits& limits) {
  const Eigen::Vector3d in = at.position_m - before.position_m;
  const Eigen::Vector3d out = after.position_m - at.position_m;
  Passage passage;
  passage.radius_m = std::min({limits.radius_m, in.norm() / 2, out.norm() / 2});
  if (passage.radius_m <= 0.0) return {};
  const double turn_rad = std::atan2(in.cross(out).norm(), in.dot(out));
  passage.speed_mps = limits.max_speed_mps;
  if (turn_rad > kStraightRad) {
    // The arc that touches both legs at the passage's radius from the corner.
    const double arc_radius_m = passage.radius_m / std::tan(turn_rad / 2);
    passage.speed_mps =
        std::min(passage.speed_mps, std::sqrt(limits.max_acceleration_mps2 * arc_radius_m));
  }
  return passage;
}

}  // namespace

double BrakingSpeed(double distance_m, double deceleration_mps2, double gain_per_s) {
  assert(distance_m >= 0.0 && deceleration_mps2 > 0.0 && gain_per_s > 0.0);
  // Where the two meet, speed and deceleration are the same: v = gain * d and v * gain = rate.
  const double linear_m = deceleration_mps2 / (gain_per_s * gain_per_s);
  if (distance_m < linear_m) return gain_per_s * distance_m;
  return std::sqrt(2.0 * deceleration_mps2 * (distance_m - linear_m / 2));
}

std::vector<Passage> PlanPassages(const std::vector<Waypoint>& waypoints,
                                  const CornerLimits& limits) {
  std::vector<Passage> passages(waypoints.size());
  for (std::size_t i = 1; i + 1 < waypoints.size(); ++i) {
    if (waypoints[i].hold_s > 0.0) continue;
    passages[i] = PlanPassage(waypoints[i - 1], waypoints[i], waypoints[i + 1], limits);
  }
  for (std::size_t i = waypoints.size(); i-- > 1;) {
    const double leg_m = (waypoints[i].position_m - waypoints[i - 1].position_m).norm();
    const double braked =
        std::sqrt(std::pow(passages[i].speed_mps, 2) + 2.0 * limits.max_deceleration_mps2 * leg_m);
    passages[i - 1].speed_mps = std::min(passages[i - 1].speed_mps, braked);
  }
  return passages;
}

}  // namespace semantic_slam
