#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

// Threads along x and y, over and under each other.
void AddWeave(Painter& painter, double thread_m, double contrast) {
  painter.AddNoise(10 * thread_m, thread_m, contrast);
  painter.AddNoise(thread_m, 10 * thread_m, contrast);
}

// Soft creases in all directions.
void AddFolds(Painter& painter, double size_m, double contrast) {
  cv::Mat1f folds = painter.Noise(size_m, 0.7 * size_m) + 0.5 * painter.Noise(0.4 * size_m);
  for (float& fold : folds) fold = static_cast<float>(contrast) * std::sin(6.0f * fold);
  painter.AddGrey(folds);
}

// A loop pile of speckled yarn.
void PaintCarpet(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const Bgr yarn = Mix(colour, Hsv(painter.Uniform(0.0, 1.0), 0.4, 0.5), 0.4);
  painter.Flecks(900, 0.008, 0.024, yarn, 35);
  painter.Flecks(500, 0.008, 0.02, Mix(colour, Bgr::all(255), 0.25), 25);
  painter.AddNoise(0.3, 5);
  painter.AddNoise(0.02, 9);
  painter.AddNoise(0.005, 14);
  painter.AddNoise(0.0025, 10);
}

// Coarse upholstery with slubs and the odd crease.
void PaintFabric(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  AddWeave(painter, 0.004, 12);
  const int slubs = cvRound(900 * painter.width_m() * painter.height_m());
  for (int i = 0; i < slubs; ++i) {
    const cv::Point2d at_m(painter.Uniform(0, painter.width_m()),
                           painter.Uniform(0, painter.height_m()));
    const double length_m = painter.Uniform(0.005, 0.02);
    const cv::Point2d along = painter.Chance(0.5) ? cv::Point2d(1, 0) : cv::Point2d(0, 1);
    painter.Line({at_m, at_m + length_m * along}, painter.Uniform(0.003, 0.006),
                 painter.Near(colour, 38));
  }
  AddFolds(painter, 0.45, 5);
  painter.AddNoise(0.0025, 6);
}

// One of a rug's ornaments: a star in a diamond.
void PaintOrnament(Painter& painter, const cv::Point2d& at_m, double size_m,
                   const std::vector<Bgr>& colours) {
  const auto diamond = [&](double scale, const Bgr& colour) {
    const double r_m = 0.5 * size_m * scale;
    painter.Polygon({at_m + cv::Point2d(r_m, 0), at_m + cv::Point2d(0, r_m),
                     at_m - cv::Point2d(r_m, 0), at_m - cv::Point2d(0, r_m)},
                    colour);
  };
  const int first = painter.Integer(0, 4);
  const auto ring = [&](int i) { return colours[(first + i) % colours.size()]; };
  diamond(1.0, ring(0));
  diamond(0.8, ring(1));
  const int points = 2 * painter.Integer(3, 5);
  std::vector<cv::Point2d> star;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = CV_PI * i / points;
    const double r_m = size_m * (i % 2 == 0 ? 0.28 : 0.13);
    star.push_back(at_m + r_m * cv::Point2d(std::cos(angle), std::sin(angle)));
  }
  painter.Polygon(star, ring(2));
  painter.Disc(at_m, 0.08 * size_m, ring(3));
}

void PaintOrnaments(Painter& painter, const std::vector<Bgr>& colours, double step_m) {
  const int columns = std::max(1, cvRound(painter.width_m() / step_m));
  const int rows = std::max(1, cvRound(painter.height_m() / step_m));
  const cv::Point2d step(painter.width_m() / columns, painter.height_m() / rows);
  const double size_m = std::min(step.x, step.y);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const cv::Point2d at_m((column + 0.5) * step.x, (row + 0.5) * step.y);
      PaintOrnament(painter, at_m, 0.92 * size_m, colours);
      painter.Disc(at_m + 0.5 * step, 0.09 * size_m, painter.Pick(colours));
    }
  }
}

// A knotted rug; as a picture with borders and a medallion in the middle.
void PaintRug(Painter& painter, const Bgr& colour) {
  const Bgr accent = Hsv(painter.Uniform(0.0, 1.0), 0.55, 0.5);
  const std::vector<Bgr> colours{colour * 0.55, Mix(colour, Bgr(190, 215, 230), 0.7), accent,
                                 Mix(colour, accent, 0.4), Mix(colour, Bgr::all(20), 0.7)};
  painter.Fill(colour);
  if (painter.wraps()) {
    PaintOrnaments(painter, colours, 0.2);
  } else {
    const double w_m = painter.width_m(), h_m = painter.height_m();
    const double border_m = std::clamp(0.12 * std::min(w_m, h_m), 0.03, 0.25);
    Painter field = painter.Part(border_m, border_m, w_m - 2 * border_m, h_m - 2 * border_m);
    PaintOrnaments(field, colours, 1.2 * border_m);
    PaintOrnament(field, {field.width_m() / 2, field.height_m() / 2},
                  0.75 * std::min(field.width_m(), field.height_m()), colours);
    for (const bool low : {false, true}) {
      Painter across = painter.Part(0, low ? h_m - border_m : 0, w_m, border_m);
      Painter down = painter.Part(low ? w_m - border_m : 0, 0, border_m, h_m);
      for (Painter* strip : {&across, &down}) {
        strip->Fill(colours[0]);
        PaintOrnaments(*strip, colours, border_m);
      }
    }
    painter.Frame(border_m, border_m, w_m - 2 * border_m, h_m - 2 * border_m, 0.08 * border_m,
                  colours[1]);
    painter.Frame(0, 0, w_m, h_m, 0.15 * border_m, colours[4]);
  }
  painter.AddNoise(0.2, 6);
  painter.AddNoise(0.006, 11);
  painter.AddNoise(0.003, 8);
}

// Drapes that hang in folds, with woven bands.
void PaintCurtain(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const int bands = 6;
  const Bgr thread = Mix(colour, Hsv(painter.Uniform(0.0, 1.0), 0.5, 0.5), 0.45);
  const double step_m = painter.height_m() / bands;
  for (int band = 0; band < bands; ++band) {
    painter.Rectangle(0, (band + 0.1) * step_m, painter.width_m(), 0.01, thread);
    painter.Rectangle(0, (band + 0.2) * step_m, painter.width_m(), 0.025, painter.Near(thread, 25));
    const int motifs = 12;
    for (int i = 0; i < motifs; ++i) {
      const cv::Point2d at_m((i + 0.5 * (band % 2)) * painter.width_m() / motifs,
                             (band + 0.65) * step_m);
      PaintOrnament(painter, at_m, painter.Uniform(0.05, 0.08),
                    {thread, colour * 0.75, Mix(colour, Bgr::all(255), 0.4)});
    }
  }
  AddWeave(painter, 0.006, 5);
  cv::Mat1f folds = painter.Noise(0.15, 2.0) + 0.3 * painter.Noise(0.2, 0.4);
  const int count = 10;
  for (int row = 0; row < folds.rows; ++row) {
    for (int column = 0; column < folds.cols; ++column) {
      const auto phase = static_cast<float>(2 * CV_PI * count * column / folds.cols);
      folds(row, column) = 24.0f * std::sin(phase + 1.4f * folds(row, column));
    }
  }
  painter.AddGrey(folds);
}

void PaintStripes(Painter& painter, const Bgr& colour, bool checked) {
  const int stripes = painter.Integer(6, 14);
  const double step_m = painter.width_m() / stripes;
  const int down = cvRound(painter.height_m() / step_m);
  const Bgr second = Luma(colour) > 110 ? colour * 0.6 : Mix(colour, Bgr::all(255), 0.35);
  const double share = painter.Uniform(0.15, 0.5);
  for (int i = 0; i < stripes; ++i) {
    painter.Rectangle(i * step_m, 0, share * step_m, painter.height_m(), second);
  }
  for (int i = 0; checked && i < down; ++i) {
    const double y_m = i * painter.height_m() / down;
    painter.Rectangle(0, y_m, painter.width_m(), share * step_m, Mix(colour, second, 0.7));
    painter.Rectangle(0, y_m + 0.7 * step_m, painter.width_m(), 0.004, second * 0.7);
  }
}

void PaintButtons(Painter& painter, const Bgr& colour) {
  const double step_m = painter.height_m() / 10;
  for (const double x_m : {0.25 * painter.width_m(), 0.75 * painter.width_m()}) {
    painter.Line({{x_m - 0.018, 0}, {x_m - 0.018, painter.height_m()}}, 0.003, colour * 0.6);
    for (int i = 0; i < 10; ++i) {
      const cv::Point2d at_m(x_m, (i + 0.5) * step_m);
      painter.Disc(at_m, 0.009, colour * 0.35);
      painter.Disc(at_m, 0.007, Mix(colour, Bgr::all(235), 0.75));
      painter.Disc(at_m, 0.002, colour * 0.35);
    }
  }
}

// Clothes: plain, striped or checked, with button facings, pockets and creases.
void PaintCloth(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const int kind = painter.Integer(0, 2);
  if (kind > 0) PaintStripes(painter, colour, kind == 2);
  for (int i = 0; i < 2; ++i) {
    const double x_m = (i + 0.6) * painter.width_m() / 2;
    const double y_m = painter.Uniform(0, painter.height_m());
    painter.Line({{x_m, y_m},
                  {x_m + 0.1, y_m},
                  {x_m + 0.1, y_m + 0.1},
                  {x_m + 0.05, y_m + 0.13},
                  {x_m, y_m + 0.1}},
                 0.003, colour * 0.55, true);
  }
  PaintButtons(painter, colour);
  AddFolds(painter, 0.3, 13);
  AddFolds(painter, 0.12, 6);
  AddWeave(painter, 0.003, 4);
}

// Grain of fine wrinkles, with a stitched seam.
void PaintLeather(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.25, 8);
  cv::Mat1f grain = cv::abs(painter.Noise(0.014)) + 0.7 * cv::abs(painter.Noise(0.006));
  painter.AddGrey(22 * cv::Mat1f(grain - 0.45));
  for (int i = 0; i < 40; ++i) {  // creases
    std::vector<cv::Point2d> points_m{
        {painter.Uniform(0, painter.width_m()), painter.Uniform(0, painter.height_m())}};
    const double heading = painter.Uniform(0, 2 * CV_PI);
    for (int step = 0; step < 6; ++step) {
      const double angle = heading + painter.Uniform(-0.6, 0.6);
      points_m.push_back(points_m.back() + 0.02 * cv::Point2d(std::cos(angle), std::sin(angle)));
    }
    painter.Line(points_m, 0.0025, Mix(colour, Bgr::all(painter.Chance(0.5) ? 0 : 255), 0.3));
  }
  const double seam_m = 0.5 * painter.height_m();
  painter.Rectangle(0, seam_m, painter.width_m(), 0.005, colour * 0.45);
  const int stitches = 80;
  for (int i = 0; i < stitches; ++i) {
    const double x_m = i * painter.width_m() / stitches;
    painter.Rectangle(x_m, seam_m - 0.01, 0.009, 0.003, Mix(colour, Bgr(170, 200, 220), 0.6));
  }
}

}  // namespace

PatternTable TextilePatterns() {
  Pattern rug = Repeating(PaintRug, 0.003, {512, 512}, false);
  rug.extent = Pattern::Extent::kEither;
  return {{"carpet", Repeating(PaintCarpet, 0.0025, {1024, 1024})},
          {"fabric", Repeating(PaintFabric, 0.0025, {512, 512})},
          {"rug", rug},
          {"curtain", Repeating(PaintCurtain, 0.003, {512, 512})},
          {"cloth", Repeating(PaintCloth, 0.002, {512, 512})},
          {"leather", Repeating(PaintLeather, 0.0025, {512, 512})}};
}

}  // namespace semantic_slam
