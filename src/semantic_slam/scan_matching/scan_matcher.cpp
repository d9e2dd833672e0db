#include "semantic_slam/scan_matching/scan_matcher.h"

namespace semantic_slam {

ScanMatcher::ScanMatcher(const ScanMatcherOptions& options,
                         const CorrelativeMatcherOptions& correlative,
                         const CeresMatcherOptions& ceres)
    : options_(Validated(options)), correlative_(correlative), ceres_(ceres) {}

std::optional<ScanMatch> ScanMatcher::Match(const PlanarPoints& points, const ProbabilityGrid& grid,
                                            const Rigid2d& T_grid_scan_expected) const {
  if (points.size() < static_cast<std::size_t>(options_.min_points)) return std::nullopt;
  const auto coarse = correlative_.Match(points, grid, T_grid_scan_expected);
  if (!coarse) return std::nullopt;
  const auto fine = ceres_.Match(points, grid, T_grid_scan_expected, coarse->T_grid_scan);
  if (!fine || fine->score < options_.min_score) return std::nullopt;
  return fine;
}

}  // namespace semantic_slam
