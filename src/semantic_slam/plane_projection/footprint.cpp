#include "semantic_slam/plane_projection/footprint.h"

#include <algorithm>

namespace semantic_slam {

std::optional<Footprint> ProjectFootprint(const std::vector<Eigen::Vector3f>& points,
                                          const std::optional<TopPlane>& top) {
  if (points.empty()) return std::nullopt;
  std::vector<Eigen::Vector2d> all;
  all.reserve(points.size());
  for (const Eigen::Vector3f& p : points) all.emplace_back(p.x(), p.y());
  Footprint footprint;
  if (top) {
    std::vector<Eigen::Vector2d> on_top;
    for (const int i : top->inliers) on_top.push_back(all[i]);
    footprint.outline_m = ConvexHull(std::move(on_top));
  }
  footprint.body_m = ConvexHull(std::move(all));
  if (footprint.body_m.empty()) return std::nullopt;
  if (footprint.outline_m.empty()) footprint.outline_m = footprint.body_m;
  const auto [lowest, highest] = std::minmax_element(
      points.begin(), points.end(),
      [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) { return a.z() < b.z(); });
  footprint.min_height_m = lowest->z();
  footprint.max_height_m = highest->z();
  return footprint;
}

}  // namespace semantic_slam
