#include <algorithm>
#include <vector>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

void AddPile(Painter& painter) {
  painter.AddNoise(0.2, 6);
  painter.AddNoise(0.006, 10);
  painter.AddNoise(0.003, 8);
}

std::vector<Bgr> Yarns(Painter& painter, const Bgr& colour) {
  const Bgr accent = Hsv(painter.Uniform(0, 1), 0.55, 0.55);
  return {colour, colour * 0.55, Mix(colour, Bgr(200, 225, 235), 0.75), accent,
          Mix(colour, accent, 0.5)};
}

// Flat-woven: bands across with rows of zigzags and lozenges.
void PaintKilim(Painter& painter, const Bgr& colour) {
  const std::vector<Bgr> yarns = Yarns(painter, colour);
  painter.Fill(colour);
  const int bands = std::max(1, cvRound(painter.height_m() / 0.12));
  const int teeth = std::max(1, cvRound(painter.width_m() / 0.12));
  const double band_m = painter.height_m() / bands, tooth_m = painter.width_m() / teeth;
  for (int band = 0; band < bands; ++band) {
    const double top = band * band_m;
    painter.Rectangle(0, top, painter.width_m(), band_m, painter.Pick(yarns));
    const Bgr figure = painter.Pick(yarns);
    const bool lozenges = painter.Chance(0.5);
    for (int i = 0; i < teeth; ++i) {
      const double left = i * tooth_m;
      painter.Polygon({{left, top + 0.85 * band_m},
                       {left + 0.5 * tooth_m, top + 0.15 * band_m},
                       {left + tooth_m, top + 0.85 * band_m},
                       {left + 0.5 * tooth_m, top + (lozenges ? 1.0 : 0.55) * band_m}},
                      figure);
    }
    painter.Rectangle(0, top, painter.width_m(), 0.08 * band_m, yarns[1]);
  }
  AddPile(painter);
}

// Long tufts of wool, in one tone.
void PaintShagRug(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.25, 8);
  const int tufts = cvRound(1500 * painter.width_m() * painter.height_m());
  for (int i = 0; i < tufts; ++i) {
    const cv::Point2d from_m(painter.Uniform(0, painter.width_m()),
                             painter.Uniform(0, painter.height_m()));
    const cv::Point2d along_m(painter.Uniform(-0.025, 0.025), painter.Uniform(-0.025, 0.025));
    painter.Line({from_m, from_m + along_m}, 0.006, painter.Near(colour, 34));
  }
  painter.AddNoise(0.01, 9);
  painter.AddNoise(0.003, 10);
}

// Overlapping plain areas, as in modern ones.
void PaintModernRug(Painter& painter, const Bgr& colour) {
  const std::vector<Bgr> yarns = Yarns(painter, colour);
  painter.Fill(colour);
  const double w_m = painter.width_m(), h_m = painter.height_m();
  for (int i = 0; i < 14; ++i) {
    const cv::Point2d at_m(painter.Uniform(0, w_m), painter.Uniform(0, h_m));
    const double size_m = painter.Uniform(0.1, 0.3) * std::min(w_m, h_m);
    const Bgr& yarn = painter.Pick(yarns);
    const int shape = painter.Integer(0, 2);
    if (shape == 0) painter.Disc(at_m, size_m, yarn);
    if (shape == 1) painter.Rectangle(at_m.x, at_m.y, 1.6 * size_m, size_m, yarn);
    if (shape == 2) {
      painter.Line({at_m, at_m + cv::Point2d(size_m, painter.Uniform(-1, 1) * size_m)},
                   0.15 * size_m, yarn);
    }
  }
  AddPile(painter);
}

Pattern RugOf(Pattern::Paint paint) {
  Pattern rug = Repeating(paint, 0.003, {512, 512}, false);
  rug.extent = Pattern::Extent::kEither;
  return rug;
}

}  // namespace

PatternTable RugPatterns() {
  return {{"kilim", RugOf(PaintKilim)},
          {"shag_rug", RugOf(PaintShagRug)},
          {"modern_rug", RugOf(PaintModernRug)}};
}

}  // namespace semantic_slam
