#include "testing/procedural_texture.h"

#include <algorithm>
#include <string>

#include "semantic_slam/worlds/painter.h"

namespace semantic_slam {
namespace {

constexpr int kSmallestEdgePx = 8;

Bgr AnyColour(Painter& painter, double low, double high) {
  return {painter.Uniform(low, high), painter.Uniform(low, high), painter.Uniform(low, high)};
}

std::string AnyLetters(Painter& painter, int count) {
  std::string letters;
  for (int i = 0; i < count; ++i) letters += static_cast<char>('A' + painter.Integer(0, 25));
  return letters;
}

void PaintChecker(Painter& painter, double x_m, double y_m, double cell_m, int columns, int rows) {
  const Bgr dark = AnyColour(painter, 10, 90), light = AnyColour(painter, 160, 250);
  for (int i = 0; i < columns * rows; ++i) {
    const int column = i % columns, row = i / columns;
    painter.Rectangle(x_m + column * cell_m, y_m + row * cell_m, cell_m, cell_m,
                      (row + column) % 2 == 0 ? dark : light);
  }
}

// A printed sheet: a frame, and a picture of some kind in it.
void PaintSheet(Painter sheet) {
  const double w_m = sheet.width_m(), h_m = sheet.height_m();
  sheet.Fill(AnyColour(sheet, 120, 240));
  sheet.Frame(0, 0, w_m, h_m, 0.04 * std::min(w_m, h_m), AnyColour(sheet, 20, 70));
  const double cell_m = w_m / 14;
  PaintChecker(sheet, sheet.Uniform(1, 6) * cell_m, 0.12 * h_m, cell_m, sheet.Integer(4, 6), 4);
  for (int i = 0; i < 12; ++i) {
    sheet.Disc({sheet.Uniform(0.15, 0.85) * w_m, sheet.Uniform(0.45, 0.75) * h_m},
               sheet.Uniform(0.01, 0.07) * w_m, AnyColour(sheet, 0, 255));
  }
  for (int i = 0; i < 10; ++i) {
    sheet.Fleck({sheet.Uniform(0.15, 0.85) * w_m, sheet.Uniform(0.2, 0.75) * h_m},
                sheet.Uniform(0.05, 0.2) * w_m, AnyColour(sheet, 0, 255));
  }
  for (const double y : {0.83, 0.88, 0.93}) {
    sheet.Text(0.1 * w_m, y * h_m, 0.03 * h_m, AnyLetters(sheet, sheet.Integer(8, 13)),
               AnyColour(sheet, 0, 70));
  }
}

void PaintWallpaper(Painter& painter) {
  const Bgr base = AnyColour(painter, 175, 225);
  painter.Fill(base);
  painter.Flecks(150.0, 0.015, 0.05, base, 45.0);
  const double step_m = 0.95;
  for (double x_m = 0.15; x_m + 0.75 < painter.width_m(); x_m += step_m) {
    const double w_m = painter.Uniform(0.5, 0.75), h_m = painter.Uniform(0.7, 1.0);
    PaintSheet(
        painter.Part(x_m + painter.Uniform(0.0, 0.1), painter.Uniform(0.35, 0.75), w_m, h_m));
  }
  // The skirting board, at the bottom.
  painter.Rectangle(0.0, painter.height_m() - 0.08, painter.width_m(), 0.08, Bgr(70, 90, 110));
}

void PaintPlanks(Painter& painter, double plank_w_m, double plank_h_m, const Bgr& wood) {
  painter.Fill(wood * 0.5);
  bool shifted = false;
  for (double y_m = 0.0; y_m < painter.height_m(); y_m += plank_h_m, shifted = !shifted) {
    for (double x_m = shifted ? -plank_w_m / 2 : 0.0; x_m < painter.width_m(); x_m += plank_w_m) {
      const Bgr colour = painter.Near(wood, 35.0);
      painter.Rectangle(x_m + 0.003, y_m + 0.003, plank_w_m - 0.006, plank_h_m - 0.006, colour);
      for (int i = 0; i < 3; ++i) {
        const double grain_m = y_m + painter.Uniform(0.1, 0.9) * plank_h_m;
        painter.Line({{x_m + painter.Uniform(0.0, 0.4) * plank_w_m, grain_m},
                      {x_m + painter.Uniform(0.5, 1.0) * plank_w_m, grain_m}},
                     0.004, colour * 0.75);
      }
    }
  }
  painter.Flecks(60.0, 0.01, 0.03, wood * 0.6, 30.0);
}

void PaintCeiling(Painter& painter) {
  PaintPlanks(painter, 0.6, 0.6, Bgr(200, 205, 205));
  painter.Flecks(100.0, 0.01, 0.03, Bgr::all(120), 50.0);
}

void PaintWood(Painter& painter) {
  PaintPlanks(painter, 0.6, 0.12, Bgr(95, 140, 190));
  // Papers lie about.
  const int papers = static_cast<int>(4.0 * painter.width_m() * painter.height_m());
  for (int i = 0; i < papers; ++i) {
    Painter paper = painter.Part(painter.Uniform(0.0, painter.width_m() - 0.2),
                                 painter.Uniform(0.0, painter.height_m() - 0.28), 0.2, 0.28);
    paper.Fill(AnyColour(paper, 215, 250));
    for (int row = 0; row < 7; ++row) {
      paper.Text(0.02, 0.05 + 0.032 * row, 0.012, AnyLetters(paper, 9), AnyColour(paper, 0, 60));
    }
  }
}

void PaintPackaging(Painter& painter) {
  const Bgr base = AnyColour(painter, 60, 220);
  painter.Fill(base);
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double size_m = std::min(w_m, h_m);
  painter.Rectangle(0.0, 0.62 * h_m, w_m, 0.2 * h_m, AnyColour(painter, 0, 255));
  PaintChecker(painter, painter.Uniform(0.05, 0.5) * w_m, 0.1 * h_m, size_m / 12, 4, 3);
  for (int i = 0; i < 6; ++i) {
    painter.Disc({painter.Uniform(0.1, 0.9) * w_m, painter.Uniform(0.1, 0.9) * h_m},
                 painter.Uniform(0.02, 0.08) * size_m, AnyColour(painter, 0, 255));
  }
  painter.Text(0.08 * w_m, 0.55 * h_m, 0.14 * size_m, AnyLetters(painter, 6),
               AnyColour(painter, 0, 60));
  painter.Text(0.08 * w_m, 0.76 * h_m, 0.08 * size_m, AnyLetters(painter, 9),
               AnyColour(painter, 200, 255));
  painter.Flecks(250.0, 0.008, 0.025, base, 90.0);
}

void Paint(Painter& painter, FaceStuff stuff) {
  switch (stuff) {
    case FaceStuff::kWallpaper:
      return PaintWallpaper(painter);
    case FaceStuff::kParquet:
      return PaintPlanks(painter, 0.45, 0.09, Bgr(70, 110, 160));
    case FaceStuff::kCeiling:
      return PaintCeiling(painter);
    case FaceStuff::kWood:
      return PaintWood(painter);
    case FaceStuff::kPackaging:
      return PaintPackaging(painter);
  }
}

}  // namespace

Texture PaintFace(FaceStuff stuff, double width_m, double height_m, double texel_m,
                  std::uint64_t seed) {
  const cv::Mat image(std::max(kSmallestEdgePx, cvRound(height_m / texel_m)),
                      std::max(kSmallestEdgePx, cvRound(width_m / texel_m)), CV_8UC3);
  Painter painter(image, texel_m, seed);
  Paint(painter, stuff);
  painter.AddNoise(0.5, 18.0);  // uneven light
  painter.AddNoise(0.02, 8.0);  // uneven paint
  return {image, Eigen::Vector2d(width_m, height_m).cast<float>()};
}

}  // namespace semantic_slam
