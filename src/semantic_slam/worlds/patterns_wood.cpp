#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

// How far through its year rings wood is cut, per texel, in rings; grain runs along x.
cv::Mat1f RingsOf(Painter& painter, double ring_m) {
  cv::Mat1f rings = painter.Noise(0.9, 0.09) * (0.05 / ring_m) + painter.Noise(0.25, 0.03) * 0.4;
  for (int row = 0; row < rings.rows; ++row) {
    rings.row(row) += row * painter.texel_m() / ring_m;
  }
  return rings;
}

// Rings bend around a knot.
void AddKnot(cv::Mat1f& rings, const cv::Point& centre_px, double radius_px) {
  const int reach_x = cvRound(7 * radius_px), reach_y = cvRound(3 * radius_px);
  for (int dy = -reach_y; dy <= reach_y; ++dy) {
    for (int dx = -reach_x; dx <= reach_x; ++dx) {
      const double far = std::hypot(dx / (2.2 * radius_px), dy / radius_px);
      const int row = (centre_px.y + dy + rings.rows) % rings.rows;
      const int column = (centre_px.x + dx + rings.cols) % rings.cols;
      rings(row, column) += static_cast<float>(5.0 * std::exp(-far * far));
    }
  }
}

// Late wood is a narrow dark line at the end of each ring.
void ShadeRings(cv::Mat1f& rings, float contrast) {
  for (float& ring : rings) {
    const float part = ring - std::floor(ring);
    ring = contrast * (0.35f - part * part * part * 1.4f);
  }
}

struct BoardLayout {
  int rows = 8;     // of boards over the period
  int per_row = 2;  // boards end to end
  double gap_m = 0.002;
  double shade_contrast = 14;
  double grain_contrast = 26;
  double ring_m = 0.012;
  int knots = 6;
};

// Boards along x in staggered rows, each cut from another place of the trunk.
void PaintBoards(Painter& painter, const Bgr& colour, const BoardLayout& layout) {
  painter.Fill(colour);
  cv::Mat1f rings = RingsOf(painter, layout.ring_m);
  std::vector<cv::Point2d> knots_m;
  for (int i = 0; i < layout.knots; ++i) {
    const cv::Point2d at_m(painter.Uniform(0, painter.width_m()),
                           (painter.Integer(0, layout.rows - 1) + painter.Uniform(0.3, 0.7)) *
                               painter.height_m() / layout.rows);
    knots_m.push_back(at_m);
    AddKnot(rings, at_m / painter.texel_m(), 0.012 / painter.texel_m());
  }
  const double length_m = painter.width_m() / layout.per_row;
  const double width_m = painter.height_m() / layout.rows;
  cv::Mat1f shade(painter.size_px(), 0.0f);
  std::vector<cv::Point2d> corners_m;
  for (int row = 0; row < layout.rows; ++row) {
    const double shift = painter.Uniform(0.0, 1.0);
    const int top = row * shade.rows / layout.rows, bottom = (row + 1) * shade.rows / layout.rows;
    for (int i = 0; i < layout.per_row; ++i) {
      corners_m.emplace_back((i + shift) * length_m, row * width_m);
      const auto cut = static_cast<float>(painter.Uniform(0.0, 10.0));
      const auto grey = static_cast<float>(layout.shade_contrast * painter.Uniform(-1.0, 1.0));
      const int left = cvRound(corners_m.back().x / painter.texel_m());
      const int right = left + shade.cols / layout.per_row;
      for (int column = left; column < right; ++column) {
        const cv::Rect strip(column % shade.cols, top, 1, bottom - top);
        rings(strip) += cut;
        shade(strip) += grey;
      }
    }
  }
  ShadeRings(rings, static_cast<float>(layout.grain_contrast));
  painter.AddGrey(rings + shade);
  painter.AddNoise(0.06, 0.002, 0.35 * layout.grain_contrast);  // pores
  painter.AddNoise(0.35, 0.08, 6);
  for (const cv::Point2d& at_m : knots_m) {
    painter.Ellipse(at_m, 0.013, 0.008, colour * 0.55);
    painter.Ellipse(at_m, 0.008, 0.005, colour * 0.38);
  }
  const Bgr gap = colour * 0.42;
  for (const cv::Point2d& at_m : corners_m) {
    painter.Rectangle(at_m.x, at_m.y, length_m, layout.gap_m, gap);
    painter.Rectangle(at_m.x, at_m.y, layout.gap_m, width_m, gap);
  }
}

// Furniture: wide glued boards.
void PaintWood(Painter& painter, const Bgr& colour) {
  BoardLayout layout;
  layout.rows = 8;
  layout.per_row = 2;
  layout.gap_m = 0.001;
  layout.shade_contrast = 9;
  PaintBoards(painter, colour, layout);
  painter.Flecks(120, 0.003, 0.01, colour * 0.7, 20);
}

void PaintParquet(Painter& painter, const Bgr& colour) {
  BoardLayout layout;
  layout.rows = 24;
  layout.per_row = 4;
  layout.gap_m = 0.0025;
  layout.shade_contrast = 24;
  layout.knots = 24;
  PaintBoards(painter, colour, layout);
  painter.Flecks(60, 0.004, 0.014, colour * 0.6, 25);
}

}  // namespace

PatternTable WoodPatterns() {
  return {{"wood", Repeating(PaintWood, 0.002, {1024, 512})},
          {"parquet", Repeating(PaintParquet, 0.0025, {1024, 1024})}};
}

}  // namespace semantic_slam
