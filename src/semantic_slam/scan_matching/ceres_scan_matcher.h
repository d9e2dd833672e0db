#pragma once

#include <optional>

#include "semantic_slam/common/options.h"
#include "semantic_slam/scan/planar_scan.h"
#include "semantic_slam/scan_matching/scan_match.h"

namespace semantic_slam {

struct CeresMatcherOptions {
  double fit_weight = 1.0;                // of all hits together
  double translation_weight_per_m = 5.0;  // of leaving the expected place
  double rotation_weight_per_rad = 10.0;  // of leaving the expected direction
  int iterations = 15;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("fit_weight", self.fit_weight, 1e-3, 1e3);
    visit("translation_weight_per_m", self.translation_weight_per_m, 0.0, 1e4);
    visit("rotation_weight_per_rad", self.rotation_weight_per_rad, 0.0, 1e4);
    visit("iterations", self.iterations, 1, 200);
  }
};

// Fits a scan onto a grid to a fraction of a cell (Hess et al., ICRA 2016, eq. CS): non-linear
// least squares on the bicubically interpolated grid, held by the expected pose. Local: it needs a
// start within a few cells. Immutable.
class CeresScanMatcher {
 public:
  // Throws ConfigError if an option is out of range.
  explicit CeresScanMatcher(const CeresMatcherOptions& options = {});

  // `points` are the scan's hits in its own frame [m]; `expected` is where the priors pull to and
  // `start` where the search begins. nullopt if there are none.
  std::optional<ScanMatch> Match(const PlanarPoints& points, const ProbabilityGrid& grid,
                                 const Rigid2d& T_grid_scan_expected,
                                 const Rigid2d& T_grid_scan_start) const;

 private:
  const CeresMatcherOptions options_;
};

}  // namespace semantic_slam
