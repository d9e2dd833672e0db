#include "semantic_slam/scan_matching/correlative_scan_matcher.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr double kRadPerDeg = M_PI / 180.0;

// The turn that moves the farthest point by one cell: Hess et al., ICRA 2016, eq. (7).
double YawStep(const PlanarPoints& points, double resolution_m) {
  double farthest_m = 3.0 * resolution_m;
  for (const Eigen::Vector2d& point : points) farthest_m = std::max(farthest_m, point.norm());
  return std::acos(1.0 - 0.5 * std::pow(resolution_m / farthest_m, 2));
}

std::vector<CellIndex> CellsOf(const PlanarPoints& points, const Rigid2d& T_grid_scan,
                               const ProbabilityGrid& grid) {
  std::vector<CellIndex> cells;
  cells.reserve(points.size());
  for (const Eigen::Vector2d& point : points) cells.push_back(grid.CellAt(T_grid_scan * point));
  return cells;
}

double MeanHitProbability(const std::vector<CellIndex>& cells, const ProbabilityGrid& grid,
                          const CellIndex& shift) {
  double sum = 0.0;
  for (const CellIndex& cell : cells) sum += HitProbability(grid.At(cell + shift));
  return sum / static_cast<double>(cells.size());
}

// 0, 1, -1, 2, -2, ...: what lies nearer comes first, and wins if another fits as well.
int Alternating(int i) {
  return i % 2 == 1 ? (i + 1) / 2 : -i / 2;
}

Rigid2d Turned(const Rigid2d& T, double yaw_rad) {
  return T * MakeRigid2d(Eigen::Vector2d::Zero(), yaw_rad);
}

}  // namespace

CorrelativeScanMatcher::CorrelativeScanMatcher(const CorrelativeMatcherOptions& options)
    : options_(Validated(options)) {}

std::optional<ScanMatch> CorrelativeScanMatcher::Match(const PlanarPoints& points,
                                                       const ProbabilityGrid& grid,
                                                       const Rigid2d& T_grid_scan_expected) const {
  if (points.empty()) return std::nullopt;
  const double step_rad = YawStep(points, grid.resolution_m());
  const int steps = static_cast<int>(options_.angular_window_deg * kRadPerDeg / step_rad);
  Best best;
  for (int i = 0; i <= 2 * steps; ++i) {
    const int yaw = Alternating(i);
    const Rigid2d turned = Turned(T_grid_scan_expected, yaw * step_rad);
    SearchTranslations(CellsOf(points, turned, grid), grid, yaw, step_rad, best);
  }
  ScanMatch match;
  match.T_grid_scan = Turned(T_grid_scan_expected, best.offset.yaw * step_rad);
  match.T_grid_scan.pretranslate(grid.resolution_m() *
                                 Eigen::Vector2d(best.offset.x, best.offset.y));
  match.score = best.fit;
  return match;
}

void CorrelativeScanMatcher::SearchTranslations(const std::vector<CellIndex>& cells,
                                                const ProbabilityGrid& grid, int yaw,
                                                double yaw_step_rad, Best& best) const {
  const double step_m = grid.resolution_m();
  const int steps = static_cast<int>(options_.linear_window_m / step_m + 1e-6);
  for (int i = 0; i <= 2 * steps; ++i) {
    for (int j = 0; j <= 2 * steps; ++j) {
      const Offset offset{Alternating(i), Alternating(j), yaw};
      const double prior = Prior(offset, step_m, yaw_step_rad);
      if (prior <= best.likelihood) continue;  // no fit is better than 1
      const double fit = MeanHitProbability(cells, grid, {offset.x, offset.y});
      if (prior * fit > best.likelihood) best = {offset, prior * fit, fit};
    }
  }
}

double CorrelativeScanMatcher::Prior(const Offset& offset, double step_m,
                                     double yaw_step_rad) const {
  const double distance_m = step_m * std::hypot(offset.x, offset.y);
  const double angle_rad = yaw_step_rad * offset.yaw;
  const double translation = distance_m / options_.translation_sigma_m;
  const double rotation = angle_rad / (options_.rotation_sigma_deg * kRadPerDeg);
  return std::exp(-0.5 * (translation * translation + rotation * rotation));
}

}  // namespace semantic_slam
