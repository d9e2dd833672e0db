#include "semantic_slam/semantic_grid/presence_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace semantic_slam {
namespace {

constexpr int kRowsPerCell = 4;
constexpr double kRounding = 1e-6;     // [cells] an edge that near a cell's is on it
constexpr double kSigmas = 3.0;        // how far the blur reaches
constexpr double kSmallestBlur = 0.1;  // [cells] less does not show

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

ConvexPolygon ToCells(ConvexPolygon outline_m, const CellLattice& lattice) {
  for (Eigen::Vector2d& corner : outline_m) {
    corner = (corner - lattice.origin_m) / lattice.resolution_m;
  }
  return outline_m;
}

cv::Rect BoundingCells(const ConvexPolygon& outline) {
  Eigen::Vector2d low = outline.front(), high = outline.front();
  for (const Eigen::Vector2d& corner : outline) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return {cv::Point(cvFloor(low.x() + kRounding), cvFloor(low.y() + kRounding)),
          cv::Point(cvCeil(high.x() - kRounding), cvCeil(high.y() - kRounding))};
}

// The part of the horizontal line at `y` that lies inside; low > high if none does.
Interval InsideAt(const ConvexPolygon& outline, double y) {
  Interval inside;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    inside.low = std::min(inside.low, x);
    inside.high = std::max(inside.high, x);
  }
  return inside;
}

// Adds to each cell of a row that begins at 0 the share that the interval covers, times `weight`.
void AddCovered(const Interval& interval, float weight, float* row, int cells) {
  const int first = std::max(cvFloor(interval.low), 0);
  const int last = std::min(cvFloor(interval.high), cells - 1);
  for (int x = first; x <= last; ++x) {
    const double covered = std::min(interval.high, x + 1.0) - std::max<double>(interval.low, x);
    row[x] += weight * static_cast<float>(std::max(covered, 0.0));
  }
}

cv::Mat Coverage(const ConvexPolygon& outline, const cv::Rect& cells) {
  cv::Mat coverage = cv::Mat::zeros(cells.size(), CV_32FC1);
  for (int v = 0; v < cells.height; ++v) {
    for (int i = 0; i < kRowsPerCell; ++i) {
      Interval inside = InsideAt(outline, cells.y + v + (i + 0.5) / kRowsPerCell);
      if (inside.low > inside.high) continue;
      inside.low -= cells.x;
      inside.high -= cells.x;
      AddCovered(inside, 1.0f / kRowsPerCell, coverage.ptr<float>(v), cells.width);
    }
  }
  return coverage;
}

// The share of a normal distribution that falls into each cell around its mean's.
cv::Mat BlurKernel(double sigma_cells) {
  if (sigma_cells < kSmallestBlur) return cv::Mat::ones(1, 1, CV_32FC1);
  const auto below = [&](double x) { return 0.5 * std::erfc(-x / (sigma_cells * std::sqrt(2.0))); };
  const int reach = cvCeil(kSigmas * sigma_cells);
  cv::Mat kernel(1, 2 * reach + 1, CV_32FC1);
  for (int i = -reach; i <= reach; ++i) {
    kernel.at<float>(i + reach) = static_cast<float>(below(i + 0.5) - below(i - 0.5));
  }
  return kernel / cv::sum(kernel)[0];
}

}  // namespace

PresencePatch RasterisePresence(const ConvexPolygon& outline_m, const Eigen::Vector2d& sigma_m,
                                const CellLattice& lattice) {
  if (outline_m.empty()) return {};
  const ConvexPolygon outline = ToCells(outline_m, lattice);
  const cv::Mat kernel_x = BlurKernel(sigma_m.x() / lattice.resolution_m);
  const cv::Mat kernel_y = BlurKernel(sigma_m.y() / lattice.resolution_m);
  const cv::Size reach(kernel_x.cols / 2, kernel_y.cols / 2);
  cv::Rect cells = BoundingCells(outline);
  cells -= cv::Point(reach);
  cells += cv::Size(2 * reach.width, 2 * reach.height);
  PresencePatch patch{cells, Coverage(outline, cells)};
  if (reach == cv::Size()) return patch;
  cv::sepFilter2D(patch.probability, patch.probability, CV_32F, kernel_x, kernel_y, {-1, -1}, 0.0,
                  cv::BORDER_CONSTANT);
  return patch;
}

}  // namespace semantic_slam
