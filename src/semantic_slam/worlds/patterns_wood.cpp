#include <algorithm>
#include <cmath>
#include <vector>

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
  double grain_contrast = 30;
  double ring_m = 0.012;
  int knots = 6;
  double bareness = 1.0;  // share of grain, knots and gaps that paint does not hide
};

// The boards' upper left corners, row by row.
std::vector<cv::Point2d> LayBoards(Painter& painter, const BoardLayout& layout) {
  std::vector<cv::Point2d> corners_m;
  for (int row = 0; row < layout.rows; ++row) {
    const double shift = painter.Uniform(0.0, 1.0);
    for (int i = 0; i < layout.per_row; ++i) {
      corners_m.emplace_back((i + shift) * painter.width_m() / layout.per_row,
                             row * painter.height_m() / layout.rows);
    }
  }
  return corners_m;
}

// `field` changes by up to `most` from board to board.
void VaryByBoard(Painter& painter, const BoardLayout& layout,
                 const std::vector<cv::Point2d>& corners_m, double most, cv::Mat1f& field) {
  for (std::size_t i = 0; i < corners_m.size(); ++i) {
    const auto step = static_cast<float>(painter.Uniform(-most, most));
    const int board_row = static_cast<int>(i) / layout.per_row;
    const int top = board_row * field.rows / layout.rows;
    const int bottom = (board_row + 1) * field.rows / layout.rows;
    const int left = cvRound(corners_m[i].x / painter.texel_m());
    const int right = left + field.cols / layout.per_row;
    for (int row = top; row < bottom; ++row) {
      for (int column = left; column < right; ++column) field(row, column % field.cols) += step;
    }
  }
}

// Where branches grew: near the middles of boards.
std::vector<cv::Point2d> Knots(Painter& painter, const BoardLayout& layout) {
  std::vector<cv::Point2d> knots_m;
  for (int i = 0; i < layout.knots; ++i) {
    const double row = painter.Integer(0, layout.rows - 1) + painter.Uniform(0.3, 0.7);
    knots_m.emplace_back(painter.Uniform(0, painter.width_m()),
                         row * painter.height_m() / layout.rows);
  }
  return knots_m;
}

// Boards along x in staggered rows, each cut from another place of the trunk.
void PaintBoards(Painter& painter, const Bgr& colour, const BoardLayout& layout) {
  const double grain = layout.bareness * layout.grain_contrast;
  const auto dark = [&](double shade) { return Mix(colour, colour * shade, layout.bareness); };
  painter.Fill(colour);
  cv::Mat1f rings = RingsOf(painter, layout.ring_m);
  const std::vector<cv::Point2d> knots_m = Knots(painter, layout);
  for (const cv::Point2d& at_m : knots_m) {
    AddKnot(rings, at_m / painter.texel_m(), 0.012 / painter.texel_m());
  }
  const std::vector<cv::Point2d> corners_m = LayBoards(painter, layout);
  VaryByBoard(painter, layout, corners_m, 5.0, rings);
  ShadeRings(rings, static_cast<float>(grain));
  VaryByBoard(painter, layout, corners_m, layout.bareness * layout.shade_contrast, rings);
  painter.AddGrey(rings);
  painter.AddNoise(0.06, 0.002, 0.35 * grain);  // pores
  painter.AddNoise(0.35, 0.08, 6);
  for (const cv::Point2d& at_m : knots_m) {
    painter.Ellipse(at_m, 0.013, 0.008, dark(0.55));
    painter.Ellipse(at_m, 0.008, 0.005, dark(0.38));
  }
  if (!(layout.gap_m > 0.0)) return;
  const Bgr gap = dark(0.42);
  for (const cv::Point2d& at_m : corners_m) {
    painter.Rectangle(at_m.x, at_m.y, painter.width_m() / layout.per_row, layout.gap_m, gap);
    painter.Rectangle(at_m.x, at_m.y, layout.gap_m, painter.height_m() / layout.rows, gap);
  }
}

// Paint hides the grain of wood that is grey or white.
double Bareness(const Bgr& colour) {
  const auto [low, high] = std::minmax({colour[0], colour[1], colour[2]});
  return std::clamp(0.2 + 2.0 * (high - low) / std::max(high, 1.0), 0.2, 1.0);
}

// Furniture: wide glued boards.
void PaintWood(Painter& painter, const Bgr& colour) {
  BoardLayout layout;
  layout.rows = 8;
  layout.per_row = 1;
  layout.gap_m = 0.001;
  layout.shade_contrast = 9;
  layout.bareness = Bareness(colour);
  PaintBoards(painter, colour, layout);
  painter.Flecks(120 * layout.bareness, 0.003, 0.01, colour * 0.7, 20);
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

// One sheet without joints: wide figures as where a trunk is cut along.
void PaintVeneer(Painter& painter, const Bgr& colour) {
  BoardLayout layout;
  layout.rows = 1;
  layout.per_row = 1;
  layout.gap_m = 0;
  layout.shade_contrast = 0;
  layout.ring_m = 0.032;  // a whole number of them in the period
  layout.grain_contrast = 24;
  layout.knots = 2;
  layout.bareness = Bareness(colour);
  PaintBoards(painter, colour, layout);
}

// Old planks with wide joints, many knots, worm holes and nails.
void PaintRusticWood(Painter& painter, const Bgr& colour) {
  BoardLayout layout;
  layout.rows = 8;
  layout.per_row = 2;
  layout.gap_m = 0.005;
  layout.shade_contrast = 26;
  layout.grain_contrast = 40;
  layout.knots = 22;
  layout.bareness = Bareness(colour);
  PaintBoards(painter, colour, layout);
  painter.Flecks(260, 0.003, 0.012, colour * 0.45, 18);
  painter.AddNoise(0.12, 8);
}

// Long chips pressed to boards, lying in all directions.
void PaintChipboard(Painter& painter, const Bgr& colour) {
  painter.Fill(colour * 0.9);
  const int chips = cvRound(1400 * painter.width_m() * painter.height_m());
  for (int i = 0; i < chips; ++i) {
    const cv::Point2d at_m(painter.Uniform(0, painter.width_m()),
                           painter.Uniform(0, painter.height_m()));
    painter.Ellipse(at_m, painter.Uniform(0.015, 0.05), painter.Uniform(0.004, 0.011),
                    painter.Near(colour, 30), painter.Uniform(0, CV_PI));
  }
  painter.AddNoise(0.02, 0.003, 6);
}

}  // namespace

PatternTable WoodPatterns() {
  return {{"wood", Repeating(PaintWood, 0.0025, {512, 512})},
          {"veneer", Repeating(PaintVeneer, 0.0025, {512, 512})},
          {"rustic_wood", Repeating(PaintRusticWood, 0.0025, {512, 512})},
          {"chipboard", Repeating(PaintChipboard, 0.0025, {512, 512})},
          {"parquet", Repeating(PaintParquet, 0.0025, {1024, 1024})}};
}

}  // namespace semantic_slam
