#pragma once

#include <cmath>

#include "semantic_slam/common/options.h"
#include "semantic_slam/common/rigid2d.h"
#include "semantic_slam/scan/planar_scan.h"
#include "semantic_slam/scan_matching/probability_grid.h"

namespace semantic_slam {

struct ScanInserterOptions {
  double hit_probability = 0.62;   // that a cell is occupied, after one beam ended in it
  double miss_probability = 0.45;  // likewise, after one beam crossed it

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("hit_probability", self.hit_probability, 0.51, 0.95);
    visit("miss_probability", self.miss_probability, 0.05, 0.49);
  }
};

// Enters planar scans into probability grids (Hess et al., ICRA 2016, section IV-B): cells in which
// beams end gain, cells that beams cross as far as they are free lose, each once per scan, and a
// cell in which one ends does not count as crossed. Immutable.
class ScanInserter {
 public:
  // Throws ConfigError if an option is out of range.
  explicit ScanInserter(const ScanInserterOptions& options = {});

  // The grid grows as needed. Precondition: the pose is finite.
  void Insert(const PlanarScan& scan, const Rigid2d& T_grid_scan, ProbabilityGrid& grid) const;

 private:
  const ProbabilityGrid::LogOdds hit_;
  const ProbabilityGrid::LogOdds miss_;
};

// Calls visit(cell) for every cell that the segment from `begin` to `end` crosses, both ends'
// included (Amanatides and Woo, Eurographics 1987). Coordinates are in cells: cell (i, j) covers
// [i, i + 1) x [j, j + 1).
template <typename Visit>
void TraverseCells(const Eigen::Vector2d& begin, const Eigen::Vector2d& end, Visit&& visit) {
  const CellIndex last = end.array().floor().cast<int>();
  CellIndex cell = begin.array().floor().cast<int>();
  const Eigen::Vector2d direction = end - begin;
  CellIndex step;
  Eigen::Vector2d next, stride;  // as fractions of the segment: to the next border, between borders
  for (int axis = 0; axis < 2; ++axis) {
    step[axis] = direction[axis] < 0.0 ? -1 : 1;
    stride[axis] = 1.0 / std::abs(direction[axis]);
    const double border = cell[axis] + (step[axis] > 0 ? 1.0 : 0.0);
    // The axis along which the segment does not leave its cell never comes next.
    next[axis] = cell[axis] == last[axis] ? 2.0 : (border - begin[axis]) / direction[axis];
  }
  visit(cell);
  while (cell != last) {
    const int axis = next.x() < next.y() ? 0 : 1;
    cell[axis] += step[axis];
    next[axis] = cell[axis] == last[axis] ? 2.0 : next[axis] + stride[axis];
    visit(cell);
  }
}

}  // namespace semantic_slam
