#include <string>
#include <vector>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

// Brushed along x.
void PaintMetal(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.5, 0.004, 7);
  painter.AddNoise(0.12, 0.008, 4);
  for (int i = 0; i < 12; ++i) {  // scratches
    const cv::Point2d from_m(painter.Uniform(0, painter.width_m()),
                             painter.Uniform(0, painter.height_m()));
    const cv::Point2d along_m(painter.Uniform(0.02, 0.1), painter.Uniform(-0.02, 0.02));
    painter.Line({from_m, from_m + along_m}, 0.001, painter.Near(colour, 18));
  }
}

void PaintPlastic(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.3, 2.0);
  painter.AddNoise(0.008, 2.0);
}

void PaintGlass(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.5, 3.0);
  painter.AddNoise(0.1, 1.0);
}

void PaintPaper(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.1, 3);
  painter.AddNoise(0.004, 4);
}

void PaintBarcode(Painter& painter, double x_m, double y_m, const Bgr& ink) {
  for (double at_m = x_m; at_m < x_m + 0.09;) {
    const double bar_m = painter.Uniform(0.002, 0.006);
    painter.Rectangle(at_m, y_m, bar_m, 0.045, ink);
    at_m += bar_m + painter.Uniform(0.002, 0.005);
  }
}

// Two arrows upwards over a line: this side up.
void PaintThisSideUp(Painter& painter, double x_m, double y_m, const Bgr& ink) {
  for (const double shift_m : {0.0, 0.05}) {
    const double at_m = x_m + shift_m;
    painter.Rectangle(at_m + 0.012, y_m + 0.03, 0.012, 0.05, ink);
    painter.Polygon({{at_m, y_m + 0.032}, {at_m + 0.018, y_m}, {at_m + 0.036, y_m + 0.032}}, ink);
  }
  painter.Rectangle(x_m, y_m + 0.09, 0.086, 0.008, ink);
}

// Corrugated, with tape and a removal firm's print.
void PaintCardboard(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.008, 0.5, 5);
  const Bgr ink = colour * 0.32;
  const double w_m = painter.width_m(), h_m = painter.height_m();
  painter.Rectangle(0, 0.46 * h_m, w_m, 0.05, Mix(colour, Bgr(120, 180, 215), 0.5));
  painter.Frame(0.0, 0.46 * h_m, w_m, 0.05, 0.002, colour * 0.75);
  for (const double y_m : {0.04 * h_m, 0.56 * h_m}) {
    for (int i = 0; i < 3; ++i) {
      const double x_m = (i + painter.Uniform(0.05, 0.3)) * w_m / 3;
      const double at_m = y_m + painter.Uniform(0.0, 0.12) * h_m;
      if (i == 0) PaintThisSideUp(painter, x_m, at_m, ink);
      if (i == 1) {
        painter.Text(x_m, at_m + 0.05, 0.04,
                     painter.Pick<std::string>({"FRAGILE", "MOVING", "PAPER"}), ink);
        painter.Print(x_m, at_m + 0.07, 0.2, 0.06, 0.02, ink);
      }
      if (i == 2) PaintBarcode(painter, x_m, at_m, ink);
    }
  }
  painter.Flecks(900, 0.003, 0.01, colour * 0.85, 16);
  painter.AddNoise(0.15, 5);
  painter.AddNoise(0.004, 4);
}

}  // namespace

PatternTable PlainPatterns() {
  return {{"metal", Repeating(PaintMetal, 0.004, {256, 256})},
          {"plastic", Repeating(PaintPlastic, 0.004, {256, 256})},
          {"glass", Repeating(PaintGlass, 0.004, {256, 256})},
          {"paper", Repeating(PaintPaper, 0.004, {256, 256})},
          {"cardboard", Repeating(PaintCardboard, 0.002, {512, 512})}};
}

}  // namespace semantic_slam
