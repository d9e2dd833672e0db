#include "semantic_slam/scan_matching/scan_inserter.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace semantic_slam {
namespace {

// What one scan says of the cells around it.
class ScanMask {
 public:
  enum Mark : std::uint8_t { kNothing, kCrossed, kEnded };

  explicit ScanMask(const CellBox& box)
      : box_(box), marks_(static_cast<std::size_t>(box.width()) * box.height(), kNothing) {}

  void Set(const CellIndex& cell, Mark mark) {
    Mark& known = marks_[static_cast<std::size_t>(cell.y() - box_.low.y()) * box_.width() +
                         (cell.x() - box_.low.x())];
    known = std::max(known, mark);
  }

  // Calls visit(cell, mark) for every cell of which the scan says something, row by row.
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    std::size_t i = 0;
    for (int y = box_.low.y(); y < box_.high.y(); ++y) {
      for (int x = box_.low.x(); x < box_.high.x(); ++x, ++i) {
        if (marks_[i] != kNothing) visit(CellIndex(x, y), marks_[i]);
      }
    }
  }

 private:
  const CellBox box_;
  std::vector<Mark> marks_;
};

// A beam in the grid.
struct GridBeam {
  Eigen::Vector2d free_from_m, free_to_m, hit_m;
  bool is_free = false;
  bool is_hit = false;
};

std::vector<GridBeam> BeamsInGrid(const PlanarScan& scan, const Rigid2d& T_grid_scan) {
  std::vector<GridBeam> beams;
  for (std::size_t i = 0; i < scan.beams.size(); ++i) {
    const ScanBeam& beam = scan.beams[i];
    if (beam.status() == BeamStatus::kUnknown) continue;
    const Eigen::Vector2d direction = scan.Direction(i);
    GridBeam in_grid;
    in_grid.is_free = beam.free_to_m > beam.free_from_m;
    in_grid.is_hit = beam.status() == BeamStatus::kHit;
    in_grid.free_from_m = T_grid_scan * (beam.free_from_m * direction);
    in_grid.free_to_m = T_grid_scan * (beam.free_to_m * direction);
    in_grid.hit_m = T_grid_scan * ((in_grid.is_hit ? beam.hit_m : beam.free_to_m) * direction);
    beams.push_back(in_grid);
  }
  return beams;
}

}  // namespace

ScanInserter::ScanInserter(const ScanInserterOptions& options)
    : hit_(ProbabilityGrid::FromProbability(Validated(options).hit_probability)),
      miss_(ProbabilityGrid::FromProbability(options.miss_probability)) {}

void ScanInserter::Insert(const PlanarScan& scan, const Rigid2d& T_grid_scan,
                          ProbabilityGrid& grid) const {
  const std::vector<GridBeam> beams = BeamsInGrid(scan, T_grid_scan);
  CellBox box;
  for (const GridBeam& beam : beams) {
    for (const Eigen::Vector2d& point_m : {beam.free_from_m, beam.free_to_m, beam.hit_m}) {
      box.Include(grid.CellAt(point_m));
    }
  }
  if (box.empty()) return;
  ScanMask mask(box);
  for (const GridBeam& beam : beams) {
    if (beam.is_free) {
      TraverseCells(beam.free_from_m / grid.resolution_m(), beam.free_to_m / grid.resolution_m(),
                    [&](const CellIndex& cell) { mask.Set(cell, ScanMask::kCrossed); });
    }
    if (beam.is_hit) mask.Set(grid.CellAt(beam.hit_m), ScanMask::kEnded);
  }
  grid.Grow(box);
  mask.ForEach([&](const CellIndex& cell, ScanMask::Mark mark) {
    grid.Add(cell, mark == ScanMask::kEnded ? hit_ : miss_);
  });
}

}  // namespace semantic_slam
