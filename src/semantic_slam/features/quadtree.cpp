#include "semantic_slam/features/quadtree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <queue>

namespace semantic_slam {
namespace {

struct Cell {
  cv::Rect2f area;
  std::vector<int> corners;  // indices
};

// The largest cell is split first, of equal ones that with most corners, of those the older one: level
// by level, so that the corners spread over the image and not over its texture.
struct SplitOrder {
  float area;
  std::size_t corners;
  std::size_t cell;
  bool operator<(const SplitOrder& other) const {
    if (area != other.area) return area < other.area;
    return corners != other.corners ? corners < other.corners : cell > other.cell;
  }
};

// Cells as square as the image allows: one per multiple of the shorter side.
std::vector<Cell> RootCells(const std::vector<cv::KeyPoint>& corners, cv::Size size) {
  const int columns = std::max(1, static_cast<int>(std::lround(
                                      static_cast<double>(size.width) / std::max(1, size.height))));
  const float width = static_cast<float>(size.width) / static_cast<float>(columns);
  std::vector<Cell> roots(columns);
  for (int i = 0; i < columns; ++i) {
    roots[i].area =
        cv::Rect2f(static_cast<float>(i) * width, 0.0f, width, static_cast<float>(size.height));
  }
  for (int i = 0; i < static_cast<int>(corners.size()); ++i) {
    const int column = std::clamp(static_cast<int>(corners[i].pt.x / width), 0, columns - 1);
    roots[column].corners.push_back(i);
  }
  return roots;
}

std::array<Cell, 4> Split(const Cell& cell, const std::vector<cv::KeyPoint>& corners) {
  const float w = cell.area.width / 2.0f, h = cell.area.height / 2.0f;
  const cv::Point2f middle(cell.area.x + w, cell.area.y + h);
  std::array<Cell, 4> quarters;
  quarters[0].area = cv::Rect2f(cell.area.x, cell.area.y, w, h);
  quarters[1].area = cv::Rect2f(middle.x, cell.area.y, w, h);
  quarters[2].area = cv::Rect2f(cell.area.x, middle.y, w, h);
  quarters[3].area = cv::Rect2f(middle.x, middle.y, w, h);
  for (const int i : cell.corners) {
    const cv::Point2f& p = corners[i].pt;
    quarters[(p.x >= middle.x ? 1 : 0) + (p.y >= middle.y ? 2 : 0)].corners.push_back(i);
  }
  return quarters;
}

const cv::KeyPoint& Strongest(const Cell& cell, const std::vector<cv::KeyPoint>& corners) {
  return corners[*std::max_element(
      cell.corners.begin(), cell.corners.end(),
      [&](int a, int b) { return corners[a].response < corners[b].response; })];
}

}  // namespace

std::vector<cv::KeyPoint> SpreadByQuadtree(const std::vector<cv::KeyPoint>& corners, cv::Size size,
                                           int wanted) {
  std::vector<Cell> cells;
  std::priority_queue<SplitOrder> to_split;
  std::size_t occupied = 0;
  const auto add = [&](Cell cell) {
    if (cell.corners.empty()) return;
    ++occupied;
    // A cell of one pixel cannot be split further: corners are at least a pixel apart.
    if (cell.corners.size() > 1 && std::min(cell.area.width, cell.area.height) > 1.0f) {
      to_split.push({cell.area.area(), cell.corners.size(), cells.size()});
    }
    cells.push_back(std::move(cell));
  };
  for (Cell& root : RootCells(corners, size)) add(std::move(root));
  while (!to_split.empty() && occupied < static_cast<std::size_t>(std::max(wanted, 0))) {
    const std::size_t index = to_split.top().cell;
    to_split.pop();
    const Cell cell = std::move(cells[index]);
    cells[index].corners.clear();
    --occupied;
    for (Cell& quarter : Split(cell, corners)) add(std::move(quarter));
  }
  std::vector<cv::KeyPoint> spread;
  spread.reserve(occupied);
  for (const Cell& cell : cells) {
    if (!cell.corners.empty()) spread.push_back(Strongest(cell, corners));
  }
  return spread;
}

}  // namespace semantic_slam
