#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace semantic_slam {

using CellIndex = Eigen::Vector2i;

// A rectangle of cells; empty unless low < high in both directions.
struct CellBox {
  CellIndex low = CellIndex::Zero();   // the first cell
  CellIndex high = CellIndex::Zero();  // one past the last

  int width() const { return high.x() - low.x(); }
  int height() const { return high.y() - low.y(); }
  bool empty() const { return width() <= 0 || height() <= 0; }
  bool Contains(const CellIndex& cell) const {
    return (cell.array() >= low.array()).all() && (cell.array() < high.array()).all();
  }
  void Include(const CellIndex& cell);
};

// Occupancy of a plane in square cells, as clamped log-odds (Moravec and Elfes, ICRA 1985; Hess et
// al., ICRA 2016, eq. 2, 3). Cell (i, j) covers [i, i + 1) x [j, j + 1) times the resolution in the
// grid's frame; the grid grows to hold what is asked of it. Two bytes a cell. Not thread-safe.
class ProbabilityGrid {
 public:
  // Evidence about one cell, in thousandths of a log-odds unit.
  using LogOdds = std::int16_t;
  static constexpr LogOdds kUnknown = INT16_MIN;
  // Certain enough to be sure, and not so certain that a door which opens stays shut: 2 % and 98 %.
  static constexpr LogOdds kMax = 3892;

  // Precondition: 0 < probability < 1.
  static LogOdds FromProbability(double probability);
  // 0.5 for a cell that nothing is known of.
  static double ToProbability(LogOdds log_odds);

  explicit ProbabilityGrid(double resolution_m) : resolution_m_(resolution_m) {}

  double resolution_m() const { return resolution_m_; }
  const CellBox& box() const { return box_; }  // of the cells in memory

  CellIndex CellAt(const Eigen::Vector2d& point_m) const;
  Eigen::Vector2d CentreOf(const CellIndex& cell) const;

  // kUnknown for a cell outside the box too.
  LogOdds At(const CellIndex& cell) const {
    return box_.Contains(cell) ? cells_[Offset(cell)] : kUnknown;
  }

  // Makes room for all cells of `box`. Never shrinks.
  void Grow(const CellBox& box);

  // Adds evidence; an unknown cell counts as even until then. Precondition: box() holds the cell.
  void Add(const CellIndex& cell, LogOdds evidence);

  // The smallest box with all cells of which something is known.
  CellBox KnownBox() const;

 private:
  std::size_t Offset(const CellIndex& cell) const {
    return static_cast<std::size_t>(cell.y() - box_.low.y()) * box_.width() +
           (cell.x() - box_.low.x());
  }

  double resolution_m_;
  CellBox box_;
  std::vector<LogOdds> cells_;  // row-major over box_
};

}  // namespace semantic_slam
