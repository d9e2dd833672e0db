#pragma once

#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/scan_matching/probability_grid.h"

namespace semantic_slam {

// Where a scan fits onto a grid.
struct ScanMatch {
  Rigid2d T_grid_scan = Rigid2d::Identity();
  double score = 0.0;  // mean probability, 0..1, that the cells are occupied in which the scan hits
};

// How well a hit fits into a cell. A cell that nothing is known of does not support a hit any more
// than a free one does.
inline double HitProbability(ProbabilityGrid::LogOdds cell) {
  return ProbabilityGrid::ToProbability(
      cell == ProbabilityGrid::kUnknown
          ? static_cast<ProbabilityGrid::LogOdds>(-ProbabilityGrid::kMax)
          : cell);
}

}  // namespace semantic_slam
