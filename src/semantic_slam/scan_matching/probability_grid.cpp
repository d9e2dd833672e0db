#include "semantic_slam/scan_matching/probability_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace semantic_slam {
namespace {

constexpr double kUnit = 1e-3;
constexpr int kGrowthCells = 32;  // a grid grows by more than is asked, so that it does so rarely

using ProbabilityTable = std::array<double, 2 * ProbabilityGrid::kMax + 1>;

ProbabilityTable MakeProbabilityTable() {
  ProbabilityTable table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double log_odds = kUnit * (static_cast<double>(i) - ProbabilityGrid::kMax);
    table[i] = 1.0 / (1.0 + std::exp(-log_odds));
  }
  return table;
}

}  // namespace

void CellBox::Include(const CellIndex& cell) {
  if (empty()) {
    low = cell;
    high = cell.array() + 1;
  } else {
    low = low.cwiseMin(cell);
    high = high.cwiseMax((cell.array() + 1).matrix());
  }
}

ProbabilityGrid::LogOdds ProbabilityGrid::FromProbability(double probability) {
  const double log_odds = std::log(probability / (1.0 - probability)) / kUnit;
  return static_cast<LogOdds>(std::lround(std::clamp<double>(log_odds, -kMax, kMax)));
}

double ProbabilityGrid::ToProbability(LogOdds log_odds) {
  static const ProbabilityTable kTable = MakeProbabilityTable();
  return log_odds == kUnknown ? 0.5 : kTable[log_odds + kMax];
}

CellIndex ProbabilityGrid::CellAt(const Eigen::Vector2d& point_m) const {
  return (point_m / resolution_m_).array().floor().cast<int>();
}

Eigen::Vector2d ProbabilityGrid::CentreOf(const CellIndex& cell) const {
  return resolution_m_ * (cell.cast<double>().array() + 0.5).matrix();
}

void ProbabilityGrid::Grow(const CellBox& box) {
  if (box.empty()) return;
  const bool fits =
      !box_.empty() && box_.Contains(box.low) && box_.Contains((box.high.array() - 1).matrix());
  if (fits) return;
  CellBox grown = box_.empty() ? box : box_;
  grown.low = grown.low.cwiseMin((box.low.array() - kGrowthCells).matrix());
  grown.high = grown.high.cwiseMax((box.high.array() + kGrowthCells).matrix());
  std::vector<LogOdds> cells(static_cast<std::size_t>(grown.width()) * grown.height(), kUnknown);
  for (int y = box_.low.y(); y < box_.high.y(); ++y) {
    const auto row = cells_.begin() + Offset({box_.low.x(), y});
    std::copy(row, row + box_.width(),
              cells.begin() + static_cast<std::size_t>(y - grown.low.y()) * grown.width() +
                  (box_.low.x() - grown.low.x()));
  }
  box_ = grown;
  cells_ = std::move(cells);
}

void ProbabilityGrid::Add(const CellIndex& cell, LogOdds evidence) {
  assert(box_.Contains(cell));
  LogOdds& value = cells_[Offset(cell)];
  const int sum = (value == kUnknown ? 0 : value) + evidence;
  value = static_cast<LogOdds>(std::clamp<int>(sum, -kMax, kMax));
}

CellBox ProbabilityGrid::KnownBox() const {
  CellBox known;
  for (int y = box_.low.y(); y < box_.high.y(); ++y) {
    for (int x = box_.low.x(); x < box_.high.x(); ++x) {
      if (cells_[Offset({x, y})] != kUnknown) known.Include({x, y});
    }
  }
  return known;
}

}  // namespace semantic_slam
