#include "semantic_slam/ground_truth/grid_score.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

// The coordinates of a point in cells; the whole part is the cell.
Eigen::Vector2d InCells(const OccupancyMap& map, const Eigen::Vector2d& point_m) {
  return (point_m - map.origin_m) / map.resolution_m;
}

bool IsOn(const OccupancyMap& map, const Eigen::Vector2d& in_cells) {
  return in_cells.x() >= 0.0 && in_cells.y() >= 0.0 && in_cells.x() < map.width &&
         in_cells.y() < map.height;
}

// Calls visit(point) for the middles of squares that fill the polygon.
template <typename Visit>
void ForEachSample(const ConvexPolygon& polygon, double spacing_m, Visit&& visit) {
  if (polygon.empty()) return;
  const double right = Support(polygon, {1.0, 0.0}), top = Support(polygon, {0.0, 1.0});
  for (double y = -Support(polygon, {0.0, -1.0}) + 0.5 * spacing_m; y < top; y += spacing_m) {
    for (double x = -Support(polygon, {-1.0, 0.0}) + 0.5 * spacing_m; x < right; x += spacing_m) {
      const Eigen::Vector2d point(x, y);
      if (Contains(polygon, point)) visit(point);
    }
  }
}

// Which cells of a grid are of a kind, and which are near one.
class CellKind {
 public:
  CellKind(const OccupancyMap& map, const cv::Mat& is_kind, double tolerance_m)
      : map_(map), is_kind_(is_kind) {
    const int reach = static_cast<int>(tolerance_m / map.resolution_m);
    cv::Mat disc(2 * reach + 1, 2 * reach + 1, CV_8UC1);
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        disc.at<std::uint8_t>(y + reach, x + reach) =
            std::hypot(x, y) * map.resolution_m <= tolerance_m;
      }
    }
    if (!is_kind.empty()) cv::dilate(is_kind, is_near_, disc);
  }

  bool IsNear(const Eigen::Vector2d& point_m) const {
    const Eigen::Vector2d cell = InCells(map_, point_m);
    if (!IsOn(map_, cell)) return false;
    return is_near_.at<std::uint8_t>(static_cast<int>(cell.y()), static_cast<int>(cell.x())) != 0;
  }

  // Calls visit(centre) for every cell of the kind.
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    for (int y = 0; y < is_kind_.rows; ++y) {
      for (int x = 0; x < is_kind_.cols; ++x) {
        if (is_kind_.at<std::uint8_t>(y, x) == 0) continue;
        visit(
            Eigen::Vector2d(map_.origin_m + map_.resolution_m * Eigen::Vector2d(x + 0.5, y + 0.5)));
      }
    }
  }

 private:
  const OccupancyMap& map_;
  const cv::Mat is_kind_;
  cv::Mat is_near_;
};

struct GridKinds {
  GridKinds(const OccupancyMap& map, const GridScoreOptions& options)
      : percent(map.height, map.width, CV_8SC1, const_cast<std::int8_t*>(map.cells.data())),
        known(map, percent >= 0, options.tolerance_m),
        free(map, (percent >= 0) & (percent < options.free_percent), options.tolerance_m),
        occupied(map, percent >= options.occupied_percent, options.tolerance_m) {}

  const cv::Mat percent;
  const CellKind known, free, occupied;
};

// Occupied cells beside free ones: what can be seen of a solid.
CellKind Outlines(const OccupancyMap& map, const GridKinds& kinds,
                  const GridScoreOptions& options) {
  const cv::Mat is_free = (kinds.percent >= 0) & (kinds.percent < options.free_percent);
  cv::Mat beside_free;
  cv::dilate(is_free, beside_free, cv::Mat::ones(3, 3, CV_8UC1));
  return CellKind(map, (kinds.percent >= options.occupied_percent) & beside_free, 0.0);
}

}  // namespace

std::int8_t PercentAt(const OccupancyMap& map, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d cell = InCells(map, point_m);
  if (!IsOn(map, cell)) return OccupancyMap::kUnknown;
  return map
      .cells[static_cast<std::size_t>(cell.y()) * map.width + static_cast<std::size_t>(cell.x())];
}

double CellCount::share() const {
  return cells > 0 ? static_cast<double>(right) / static_cast<double>(cells) : 1.0;
}

GridScore ScoreGrid(const OccupancyMap& truth, const OccupancyMap& estimate,
                    const Rigid2d& T_truth_estimate, const GridScoreOptions& options) {
  Validate(options);
  GridScore score;
  if (truth.cells.empty() || estimate.cells.empty()) return score;
  const GridKinds true_kinds(truth, options), estimated(estimate, options);
  const Rigid2d &to_truth = T_truth_estimate, to_estimate = T_truth_estimate.inverse();
  const auto count_precision = [&](const CellKind& kind, const CellKind& true_kind,
                                   CellCount& count) {
    kind.ForEach([&](const Eigen::Vector2d& centre) {
      const Eigen::Vector2d point = to_truth * centre;
      if (!true_kinds.known.IsNear(point)) return;
      ++count.cells;
      count.right += true_kind.IsNear(point);
    });
  };
  const auto count_recall = [&](const CellKind& true_kind, const CellKind& kind, CellCount& count) {
    true_kind.ForEach([&](const Eigen::Vector2d& centre) {
      const Eigen::Vector2d point = to_estimate * centre;
      if (!estimated.known.IsNear(point)) return;
      ++count.cells;
      count.right += kind.IsNear(point);
    });
  };
  count_precision(estimated.free, true_kinds.free, score.free_precision);
  count_precision(estimated.occupied, true_kinds.occupied, score.occupied_precision);
  count_recall(true_kinds.free, estimated.free, score.free_recall);
  count_recall(Outlines(truth, true_kinds, options), estimated.occupied, score.occupied_recall);
  return score;
}

CellCount OccupiedArea(const std::vector<ConvexPolygon>& polygons_m, const OccupancyMap& estimate,
                       const Rigid2d& T_truth_estimate, double spacing_m,
                       const GridScoreOptions& options) {
  Validate(options);
  const Rigid2d to_estimate = T_truth_estimate.inverse();
  CellCount count;
  for (const ConvexPolygon& polygon : polygons_m) {
    ForEachSample(polygon, spacing_m, [&](const Eigen::Vector2d& point) {
      ++count.cells;
      count.right += PercentAt(estimate, to_estimate * point) >= options.occupied_percent;
    });
  }
  return count;
}

void FillPolygon(const ConvexPolygon& polygon_m, OccupancyMap& map) {
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const Eigen::Vector2d centre =
          map.origin_m + map.resolution_m * Eigen::Vector2d(x + 0.5, y + 0.5);
      if (Contains(polygon_m, centre)) map.cells[static_cast<std::size_t>(y) * map.width + x] = 100;
    }
  }
}

}  // namespace semantic_slam
