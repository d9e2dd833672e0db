#include <cmath>
#include <vector>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

// Adds waves of `count` periods over the painter's width, that bend by `bend` noise of `size_m`.
void AddRibs(Painter& painter, int count, double contrast, double bend, double size_x_m,
             double size_y_m) {
  cv::Mat1f ribs = painter.Noise(size_x_m, size_y_m);
  for (int row = 0; row < ribs.rows; ++row) {
    for (int column = 0; column < ribs.cols; ++column) {
      const double phase = 2 * CV_PI * count * column / ribs.cols;
      ribs(row, column) = static_cast<float>(contrast * std::sin(phase + bend * ribs(row, column)));
    }
  }
  painter.AddGrey(ribs);
}

// The drapery of a curtain that hangs.
void AddHangingFolds(Painter& painter) {
  AddRibs(painter, 10, 24, 1.4, 0.15, 2.0);
}

// Ribbed velvet.
void PaintCorduroy(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.2, 9);
  AddRibs(painter, 64, 20, 0.5, 0.1, 0.3);
  painter.AddNoise(0.03, 0.006, 6);
  painter.AddNoise(0.0025, 7);
  for (int i = 0; i < 24; ++i) {  // where the pile is pressed
    painter.Fleck({painter.Uniform(0, painter.width_m()), painter.Uniform(0, painter.height_m())},
                  painter.Uniform(0.02, 0.06), painter.Near(colour * 0.9, 14));
  }
}

// Wool woven in zigzags of two yarns, with knots of others.
void PaintTweed(Painter& painter, const Bgr& colour) {
  const Bgr second = Luma(colour) > 110 ? colour * 0.55 : Mix(colour, Bgr::all(235), 0.4);
  painter.Fill(colour);
  const int columns = 32, rows = 64;
  const double step_x_m = painter.width_m() / columns, step_y_m = painter.height_m() / rows;
  for (int column = 0; column < columns; ++column) {
    const double rise_m = (column % 2 == 0 ? 1.0 : -1.0) * 1.5 * step_y_m;
    for (int row = 0; row < rows; ++row) {
      const double x_m = column * step_x_m, y_m = (row + 0.5) * step_y_m;
      painter.Line({{x_m, y_m - 0.5 * rise_m}, {x_m + step_x_m, y_m + 0.5 * rise_m}},
                   0.45 * step_y_m, second);
    }
  }
  painter.Flecks(700, 0.006, 0.014, Mix(colour, Hsv(painter.Uniform(0, 1), 0.6, 0.7), 0.6), 40);
  painter.AddNoise(0.2, 5);
  painter.AddNoise(0.0025, 9);
}

// Stripes of many widths along y.
void PaintStripedFabric(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const Bgr accent = Hsv(painter.Uniform(0, 1), 0.5, 0.65);
  const std::vector<Bgr> tones{colour * 0.6, Mix(colour, Bgr::all(250), 0.6), accent,
                               Mix(colour, accent, 0.5)};
  const int stripes = painter.Integer(10, 16);
  const double step_m = painter.width_m() / stripes;
  for (int i = 0; i < stripes; ++i) {
    painter.Rectangle(i * step_m, 0, painter.Uniform(0.2, 0.75) * step_m, painter.height_m(),
                      painter.Pick(tones));
  }
  painter.AddNoise(0.04, 0.004, 7);
  painter.AddNoise(0.004, 0.04, 7);
  painter.AddNoise(0.3, 5);
  painter.AddNoise(0.0025, 6);
}

void PaintBlossom(Painter& painter, const cv::Point2d& at_m, double size_m, const Bgr& petal,
                  const Bgr& leaf) {
  const double turn = painter.Uniform(0, 2 * CV_PI);
  const auto spot = [&](double angle, double far) {
    return at_m + far * size_m * cv::Point2d(std::cos(turn + angle), std::sin(turn + angle));
  };
  for (int i = 0; i < 3; ++i) {
    painter.Ellipse(spot(2.1 * i, 0.75), 0.4 * size_m, 0.16 * size_m, leaf, turn + 2.1 * i);
  }
  for (int i = 0; i < 6; ++i) {
    const double angle = CV_PI / 3 * i;
    painter.Ellipse(spot(angle, 0.35), 0.3 * size_m, 0.2 * size_m, painter.Near(petal, 18),
                    turn + angle);
  }
  painter.Disc(at_m, 0.14 * size_m, Mix(petal, Bgr(60, 200, 230), 0.6));
}

// Blossoms of two colours, scattered.
void PaintBlossoms(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const Bgr petal = Hsv(painter.Uniform(0, 1), 0.5, 0.8),
            other = Hsv(painter.Uniform(0, 1), 0.4, 0.9);
  const Bgr leaf = Hsv(painter.Uniform(0.22, 0.42), 0.45, 0.4);
  const int cells = 9;
  const cv::Point2d step(painter.width_m() / cells, painter.height_m() / cells);
  for (int i = 0; i < cells * cells; ++i) {
    const cv::Point2d at_m((i % cells + painter.Uniform(0.2, 0.8)) * step.x,
                           (i / cells + painter.Uniform(0.2, 0.8)) * step.y);
    PaintBlossom(painter, at_m, painter.Uniform(0.35, 0.6) * step.x,
                 painter.Chance(0.6) ? petal : other, leaf);
  }
}

void PaintFloralFabric(Painter& painter, const Bgr& colour) {
  PaintBlossoms(painter, colour);
  painter.AddNoise(0.3, 5);
  painter.AddNoise(0.003, 7);
}

void PaintFloralCurtain(Painter& painter, const Bgr& colour) {
  PaintBlossoms(painter, colour);
  AddHangingFolds(painter);
  painter.AddNoise(0.004, 4);
}

// Broad bands across.
void PaintBandedCurtain(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const Bgr accent = Mix(colour, Hsv(painter.Uniform(0, 1), 0.6, 0.55), 0.6);
  const int bands = 5;
  const double step_m = painter.height_m() / bands;
  for (int i = 0; i < bands; ++i) {
    painter.Rectangle(0, i * step_m, painter.width_m(), painter.Uniform(0.25, 0.5) * step_m,
                      painter.Near(accent, 30));
    painter.Rectangle(0, (i + 0.7) * step_m, painter.width_m(), 0.02, colour * 0.6);
  }
  AddHangingFolds(painter);
  painter.AddNoise(0.005, 8);
  painter.AddNoise(0.03, 0.006, 5);
}

// Thin stuff through which the light comes: narrow folds and little else.
void PaintSheerCurtain(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  AddRibs(painter, 18, 14, 1.6, 0.1, 2.0);
  painter.AddNoise(0.01, 0.3, 5);
  painter.AddNoise(0.006, 4);
  for (int i = 0; i < 14; ++i) {  // woven dots
    const double y_m = (i + 0.5) * painter.height_m() / 14;
    for (int j = 0; j < 14; ++j) {
      const double x_m = (j + 0.5 * (i % 2) + 0.25) * painter.width_m() / 14;
      painter.Disc({x_m, y_m}, 0.008, Mix(colour, Bgr::all(255), 0.4));
    }
  }
}

}  // namespace

PatternTable UpholsteryPatterns() {
  return {{"corduroy", Repeating(PaintCorduroy, 0.0025, {512, 512})},
          {"tweed", Repeating(PaintTweed, 0.0025, {512, 512})},
          {"striped_fabric", Repeating(PaintStripedFabric, 0.0025, {512, 512})},
          {"floral_fabric", Repeating(PaintFloralFabric, 0.0025, {512, 512})},
          {"floral_curtain", Repeating(PaintFloralCurtain, 0.003, {512, 512})},
          {"banded_curtain", Repeating(PaintBandedCurtain, 0.003, {512, 512})},
          {"sheer_curtain", Repeating(PaintSheerCurtain, 0.003, {512, 512})}};
}

}  // namespace semantic_slam
