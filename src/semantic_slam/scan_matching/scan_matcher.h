#pragma once

#include <optional>

#include "semantic_slam/common/options.h"
#include "semantic_slam/scan_matching/ceres_scan_matcher.h"
#include "semantic_slam/scan_matching/correlative_scan_matcher.h"

namespace semantic_slam {

struct ScanMatcherOptions {
  int min_points = 30;     // scans with fewer hits are not matched
  double min_score = 0.4;  // a fit below this is not believed

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("min_points", self.min_points, 1, 10000);
    visit("min_score", self.min_score, 0.0, 1.0);
  }
};

// Scan-to-submap matching of thesis section 3.4.2: the correlative search finds the cell, Ceres the
// place in it; both are held by the expected pose. Immutable.
class ScanMatcher {
 public:
  // Throws ConfigError if an option is out of range.
  ScanMatcher(const ScanMatcherOptions& options, const CorrelativeMatcherOptions& correlative,
              const CeresMatcherOptions& ceres);

  // nullopt if the scan has too few hits or does not fit.
  std::optional<ScanMatch> Match(const PlanarPoints& points, const ProbabilityGrid& grid,
                                 const Rigid2d& T_grid_scan_expected) const;

 private:
  const ScanMatcherOptions options_;
  const CorrelativeScanMatcher correlative_;
  const CeresScanMatcher ceres_;
};

}  // namespace semantic_slam
