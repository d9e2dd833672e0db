#pragma once

#include <optional>
#include <vector>

#include "semantic_slam/common/options.h"
#include "semantic_slam/scan/planar_scan.h"
#include "semantic_slam/scan_matching/scan_match.h"

namespace semantic_slam {

struct CorrelativeMatcherOptions {
  double linear_window_m = 0.1;      // looked at to either side of the expected place
  double angular_window_deg = 5.0;   // and of the expected direction
  double translation_sigma_m = 0.1;  // how far the expected place tends to be wrong
  double rotation_sigma_deg = 3.0;   // and the expected direction

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("linear_window_m", self.linear_window_m, 0.0, 5.0);
    visit("angular_window_deg", self.angular_window_deg, 0.0, 180.0);
    visit("translation_sigma_m", self.translation_sigma_m, 1e-3, 100.0);
    visit("rotation_sigma_deg", self.rotation_sigma_deg, 1e-2, 360.0);
  }
};

// Real-time correlative scan matching (Olson, ICRA 2009, eq. 3; thesis section 3.4.2): tries every
// pose of a window about the expected one, and takes the one with the highest product of the scan's
// fit and the prior. Exhaustive, so no local optimum catches it; the answer is as coarse as the
// grid. Immutable.
class CorrelativeScanMatcher {
 public:
  // Throws ConfigError if an option is out of range.
  explicit CorrelativeScanMatcher(const CorrelativeMatcherOptions& options = {});

  // `points` are the scan's hits in its own frame [m]. nullopt if there are none.
  std::optional<ScanMatch> Match(const PlanarPoints& points, const ProbabilityGrid& grid,
                                 const Rigid2d& T_grid_scan_expected) const;

 private:
  // Whole steps away from the expected pose.
  struct Offset {
    int x = 0, y = 0, yaw = 0;
  };
  struct Best {
    Offset offset;
    double likelihood = -1.0;  // fit times prior
    double fit = 0.0;
  };

  void SearchTranslations(const std::vector<CellIndex>& cells, const ProbabilityGrid& grid, int yaw,
                          double yaw_step_rad, Best& best) const;
  double Prior(const Offset& offset, double step_m, double yaw_step_rad) const;

  const CorrelativeMatcherOptions options_;
};

}  // namespace semantic_slam
