#include "semantic_slam/plane_projection/top_plane.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace semantic_slam {
namespace {

constexpr int kMaxPlanes = 3;  // looked for: a top, and what may lie below or above it

double MeanHeight(const std::vector<Eigen::Vector3f>& points, const std::vector<int>& indices) {
  double sum = 0.0;
  for (const int i : indices) sum += points[i].z();
  return sum / static_cast<double>(indices.size());
}

// Takes `taken` (ascending) out of `remaining`.
void Remove(std::vector<int>& remaining, const std::vector<int>& taken) {
  std::vector<int> rest;
  std::set_difference(remaining.begin(), remaining.end(), taken.begin(), taken.end(),
                      std::back_inserter(rest));
  remaining.swap(rest);
}

// The largest level plane through the points that `remaining` names.
std::optional<TopPlane> LargestLevelPlane(const std::vector<Eigen::Vector3f>& points,
                                          const std::vector<int>& remaining, int min_points,
                                          const PlaneConstraint& level) {
  std::vector<Eigen::Vector3f> candidates;
  candidates.reserve(remaining.size());
  for (const int i : remaining) candidates.push_back(points[i]);
  const auto fit = FitPlane(candidates, min_points, level);
  if (!fit) return std::nullopt;
  TopPlane top;
  top.plane = fit->plane;
  for (const int i : fit->inliers) top.inliers.push_back(remaining[i]);
  top.height_m = MeanHeight(points, top.inliers);
  return top;
}

}  // namespace

std::optional<TopPlane> FindTopPlane(const std::vector<Eigen::Vector3f>& points,
                                     const TopPlaneOptions& options) {
  PlaneConstraint level;
  level.tolerance_m = options.tolerance_m;
  level.max_iterations = options.max_iterations;
  level.axis = Eigen::Vector3d::UnitZ();
  level.max_tilt_rad = options.max_tilt_rad;
  auto enough =
      std::max(options.min_points,
               static_cast<int>(std::ceil(options.min_share * static_cast<double>(points.size()))));
  std::vector<int> remaining(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) remaining[i] = static_cast<int>(i);
  std::optional<TopPlane> top;
  for (int i = 0; i < kMaxPlanes; ++i) {
    const auto next = LargestLevelPlane(points, remaining, enough, level);
    if (!next) break;
    Remove(remaining, next->inliers);
    if (!top) {  // from now on the others are measured against the largest
      const double share = options.upper_share * static_cast<double>(next->inliers.size());
      enough = std::max(enough, static_cast<int>(std::ceil(share)));
    }
    if (!top || next->height_m > top->height_m + options.tolerance_m) top = next;
  }
  return top;
}

}  // namespace semantic_slam
