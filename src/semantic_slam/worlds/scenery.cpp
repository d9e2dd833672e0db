#include "semantic_slam/worlds/scenery.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

// Distances in a scene are shares of its shorter side.
double UnitOf(const Painter& painter) {
  return std::min(painter.width_m(), painter.height_m());
}

void PaintClouds(Painter& painter) {
  const double unit_m = UnitOf(painter);
  cv::Mat1f clouds = painter.Noise(0.5 * unit_m, 0.16 * unit_m) +
                     0.5 * painter.Noise(0.2 * unit_m, 0.07 * unit_m) +
                     0.25 * painter.Noise(0.08 * unit_m, 0.04 * unit_m);
  clouds = cv::max(cv::min(1.6 * clouds, 0.85), 0.0);
  painter.Glaze(Bgr(248, 248, 250), clouds);
}

// A skyline of mountains: `height` of the image at most, from `base` (0 top .. 1 bottom).
void PaintRidge(Painter& painter, double base, double height, const Bgr& colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  const double phase = painter.Uniform(0, 10), stretch = painter.Uniform(3, 6);
  std::vector<cv::Point2d> line_m{{-0.1 * w_m, 1.1 * h_m}};
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = -0.05 + 1.1 * i / kSteps;
    const double peak = 0.5 + 0.35 * std::sin(stretch * x + phase) +
                        0.2 * std::sin(2.7 * stretch * x + 2 * phase) +
                        painter.Uniform(-0.08, 0.08);
    line_m.emplace_back(x * w_m, (base - height * std::max(0.0, peak)) * h_m);
  }
  line_m.emplace_back(1.1 * w_m, 1.1 * h_m);
  painter.Polygon(line_m, colour);
}

void PaintTree(Painter& painter, const cv::Point2d& foot_m, double height_m) {
  const Bgr green =
      Hsv(painter.Uniform(0.2, 0.4), painter.Uniform(0.4, 0.7), painter.Uniform(0.25, 0.5));
  painter.Line({foot_m, foot_m - cv::Point2d(0, 0.5 * height_m)}, 0.07 * height_m, Bgr(35, 50, 70));
  const int tufts = 80;
  for (int i = 0; i < tufts; ++i) {
    const double up = painter.Uniform(0.35, 1.0);
    const double reach = 0.3 * std::sin(CV_PI * std::min(1.0, 1.25 - up));
    const cv::Point2d at_m = foot_m + height_m * cv::Point2d(painter.Uniform(-reach, reach), -up);
    painter.Fleck(at_m, painter.Uniform(0.06, 0.15) * height_m,
                  painter.Near(green * (0.6 + 0.5 * up), 22));
  }
}

void PaintMeadow(Painter& painter, double horizon, const Bgr& green) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  Painter meadow = painter.Part(0, horizon * h_m, w_m, (1 - horizon) * h_m);
  meadow.Gradient(Mix(green, Bgr(150, 210, 200), 0.3), green * 0.7);
  meadow.AddNoise(0.1 * w_m, 0.02 * h_m, 14);
  const double unit_m = UnitOf(painter);
  for (int i = 0; i < 250; ++i) {
    const double near = std::pow(painter.Uniform(0.0, 1.0), 1.5);
    const cv::Point2d at_m(painter.Uniform(0, w_m), near * meadow.height_m());
    const Bgr bloom = Hsv(painter.Uniform(-0.15, 0.17), 0.5, 0.9);
    meadow.Fleck(at_m, (0.005 + 0.012 * near) * unit_m,
                 painter.Chance(0.4) ? bloom : painter.Near(green * 0.8, 40));
  }
}

void PaintLake(Painter& painter, double horizon, const Bgr& sky) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  Painter lake = painter.Part(0, horizon * h_m, w_m, 0.45 * (1 - horizon) * h_m);
  lake.Gradient(sky * 0.9, sky * 0.5);
  lake.AddNoise(0.12 * w_m, 0.008 * h_m, 28);
}

void PaintHouse(Painter& painter, double x_m, double foot_m, double width_m, double height_m) {
  const Bgr wall =
      Hsv(painter.Uniform(0.02, 0.14), painter.Uniform(0.1, 0.5), painter.Uniform(0.6, 0.95));
  const Bgr roof =
      Hsv(painter.Uniform(0.0, 0.06), painter.Uniform(0.3, 0.7), painter.Uniform(0.3, 0.6));
  const double eaves_m = foot_m - height_m;
  painter.Rectangle(x_m, eaves_m, width_m, height_m, wall);
  painter.Polygon({{x_m - 0.06 * width_m, eaves_m},
                   {x_m + 0.5 * width_m, eaves_m - 0.45 * height_m},
                   {x_m + 1.06 * width_m, eaves_m}},
                  roof);
  painter.Rectangle(x_m + 0.7 * width_m, eaves_m - 0.4 * height_m, 0.09 * width_m, 0.3 * height_m,
                    roof * 0.7);
  const int columns = painter.Integer(2, 4);
  const int rows = std::max(1, cvRound(0.7 * columns * height_m / width_m));
  for (int i = 0; i < columns * rows; ++i) {
    const double w_m = 0.5 * width_m / columns, h_m = 0.5 * height_m / rows;
    const double at_x_m = x_m + (i % columns + 0.25) * width_m / columns;
    const double at_y_m = eaves_m + (i / columns + 0.2) * height_m / rows;
    painter.Rectangle(at_x_m, at_y_m, w_m, h_m, Bgr(90, 70, 50));
    painter.Frame(at_x_m, at_y_m, w_m, h_m, 0.14 * w_m, Bgr(240, 242, 244));
    painter.Rectangle(at_x_m + 0.44 * w_m, at_y_m, 0.12 * w_m, h_m, Bgr(240, 242, 244));
  }
}

}  // namespace

void PaintLandscape(Painter& painter, const Bgr& sky) {
  const double w_m = painter.width_m(), h_m = painter.height_m(), unit_m = UnitOf(painter);
  painter.Gradient(sky, Mix(sky, Bgr(225, 238, 248), 0.7));
  PaintClouds(painter);
  const double horizon = painter.Uniform(0.5, 0.65);
  const Bgr far = Mix(sky, Bgr(110, 90, 80), 0.45);
  const Bgr green = Hsv(painter.Uniform(0.17, 0.36), 0.55, painter.Uniform(0.35, 0.6));
  for (int i = 0; i < 4; ++i) {
    PaintRidge(painter, horizon + 0.02 * i, 0.34 - 0.08 * i, Mix(far, green * 0.6, i / 3.5));
  }
  PaintMeadow(painter, horizon, green);
  if (painter.Chance(0.5)) PaintLake(painter, horizon, sky);
  const int trees = painter.Integer(4, 9);
  for (int i = 0; i < trees; ++i) {
    const double near = (i + 1.0) / trees;
    PaintTree(
        painter,
        {painter.Uniform(0, w_m), (horizon + (0.9 - horizon) * near * near) * h_m + 0.02 * h_m},
        (0.1 + 0.3 * near) * unit_m);
  }
}

void PaintStreet(Painter& painter, const Bgr& sky) {
  const double w_m = painter.width_m(), h_m = painter.height_m();
  painter.Gradient(sky, Mix(sky, Bgr(235, 242, 248), 0.75));
  PaintClouds(painter);
  const double horizon = 0.62;
  PaintRidge(painter, horizon, 0.2, Mix(sky, Bgr(95, 120, 90), 0.6));
  PaintMeadow(painter, horizon, Hsv(0.27, 0.5, 0.5));
  const double foot_m = (horizon + 0.04) * h_m;
  const int houses = std::max(2, cvRound(2.2 * w_m / h_m));
  for (int i = 0; i < houses; ++i) {
    PaintHouse(painter, (i + painter.Uniform(0.05, 0.2)) * w_m / houses, foot_m,
               painter.Uniform(0.55, 0.75) * w_m / houses, painter.Uniform(0.16, 0.32) * h_m);
  }
  painter.Rectangle(0, 0.76 * h_m, w_m, 0.09 * h_m, Bgr(105, 102, 100));
  for (int i = 0; i < 8; ++i) {
    painter.Rectangle((i + 0.2) * w_m / 8, 0.8 * h_m, 0.05 * w_m, 0.01 * h_m, Bgr::all(225));
  }
  for (int i = 0; i < 3; ++i) {
    PaintTree(painter,
              {(i + painter.Uniform(0.1, 0.9)) * w_m / 3, painter.Uniform(0.74, 1.0) * h_m},
              painter.Uniform(0.3, 0.6) * h_m);
  }
}

void PaintPortrait(Painter& painter, const Bgr& background) {
  const double unit_m = UnitOf(painter);
  const cv::Point2d head(painter.width_m() * painter.Uniform(0.4, 0.6), 0.42 * painter.height_m());
  const Bgr skin =
      Hsv(painter.Uniform(0.04, 0.08), painter.Uniform(0.3, 0.6), painter.Uniform(0.45, 0.95));
  const Bgr hair =
      Hsv(painter.Uniform(0.02, 0.12), painter.Uniform(0.2, 0.7), painter.Uniform(0.1, 0.6));
  const Bgr coat = Hsv(painter.Uniform(0, 1), painter.Uniform(0.2, 0.8), painter.Uniform(0.2, 0.7));
  const auto at = [&](double x, double y) { return head + unit_m * cv::Point2d(x, y); };
  painter.Gradient(background, background * 0.45);
  painter.AddNoise(0.3 * unit_m, 14);
  painter.Ellipse(at(0, painter.Uniform(-0.05, 0.08)), painter.Uniform(0.18, 0.22) * unit_m,
                  painter.Uniform(0.22, 0.36) * unit_m, hair);
  painter.Ellipse(at(0, 0.68), 0.42 * unit_m, 0.36 * unit_m, coat);
  painter.Polygon({at(-0.08, 0.1), at(0.08, 0.1), at(0.1, 0.36), at(0, 0.42), at(-0.1, 0.36)},
                  skin * 0.85);
  painter.Polygon({at(-0.11, 0.35), at(0, 0.55), at(0.11, 0.35), at(0.04, 0.7), at(-0.04, 0.7)},
                  Mix(coat, Bgr::all(240), 0.7));
  painter.Ellipse(at(0, 0.02), 0.155 * unit_m, 0.2 * unit_m, skin);
  painter.Ellipse(at(0.05, 0.03), 0.1 * unit_m, 0.17 * unit_m, Mix(skin, Bgr::all(255), 0.12));
  painter.Polygon({at(-0.17, -0.02), at(-0.1, -0.1), at(0.08, -0.12), at(0.17, 0), at(0.14, -0.2),
                   at(-0.1, -0.23)},
                  hair);
  for (const double side : {-0.065, 0.065}) {
    painter.Ellipse(at(side, 0), 0.03 * unit_m, 0.015 * unit_m, Bgr::all(240));
    painter.Disc(at(side, 0), 0.013 * unit_m, Bgr(40, 30, 25));
    painter.Line({at(side - 0.035, -0.04), at(side, -0.05), at(side + 0.035, -0.04)}, 0.01 * unit_m,
                 hair * 0.7);
  }
  painter.Line({at(0, 0), at(0.02, 0.07), at(-0.01, 0.075)}, 0.008 * unit_m, skin * 0.65);
  painter.Ellipse(at(0, 0.125), 0.05 * unit_m, 0.014 * unit_m, Bgr(80, 75, 170));
}

void PaintStillLife(Painter& painter, const Bgr& background) {
  const double w_m = painter.width_m(), h_m = painter.height_m(), unit_m = UnitOf(painter);
  painter.Gradient(background * 0.4, background);
  painter.AddNoise(0.2 * unit_m, 12);
  const Bgr table = Hsv(0.07, 0.5, 0.4);
  painter.Rectangle(0, 0.66 * h_m, w_m, 0.34 * h_m, table);
  const cv::Point2d vase(painter.Uniform(0.3, 0.7) * w_m, 0.55 * h_m);
  const Bgr glaze = Hsv(painter.Uniform(0.5, 0.7), 0.5, 0.6);
  painter.Ellipse(vase, 0.12 * unit_m, 0.2 * unit_m, glaze);
  painter.Ellipse(vase - cv::Point2d(0.04, 0.05) * unit_m, 0.02 * unit_m, 0.08 * unit_m,
                  Mix(glaze, Bgr::all(255), 0.6));
  for (int i = 0; i < 16; ++i) {
    const cv::Point2d bloom =
        vase + unit_m * cv::Point2d(painter.Uniform(-0.28, 0.28), painter.Uniform(-0.5, -0.22));
    painter.Line({vase - cv::Point2d(0, 0.18 * unit_m), bloom}, 0.008 * unit_m, Bgr(50, 90, 50));
    painter.Disc(bloom, painter.Uniform(0.03, 0.07) * unit_m,
                 Hsv(painter.Uniform(-0.1, 0.16), 0.7, 0.9));
    painter.Disc(bloom, 0.018 * unit_m, Hsv(0.13, 0.8, 0.6));
  }
  for (int i = 0; i < 7; ++i) {
    const cv::Point2d fruit(painter.Uniform(0.1, 0.9) * w_m, painter.Uniform(0.72, 0.85) * h_m);
    const double r_m = painter.Uniform(0.06, 0.1) * unit_m;
    const Bgr peel = Hsv(painter.Uniform(-0.02, 0.3), 0.75, 0.8);
    painter.Ellipse(fruit + cv::Point2d(0.5 * r_m, 0.6 * r_m), 1.2 * r_m, 0.6 * r_m, table * 0.5);
    painter.Disc(fruit, r_m, peel);
    painter.Disc(fruit - 0.35 * cv::Point2d(r_m, r_m), 0.3 * r_m, Mix(peel, Bgr::all(255), 0.5));
  }
}

void PaintAbstract(Painter& painter, const Bgr& main_colour) {
  const double w_m = painter.width_m(), h_m = painter.height_m(), unit_m = UnitOf(painter);
  painter.Gradient(main_colour, Mix(main_colour, Bgr::all(255), 0.3));
  const double hue = painter.Uniform(0, 1);
  for (int i = 0; i < 26; ++i) {
    const cv::Point2d at_m(painter.Uniform(0, w_m), painter.Uniform(0, h_m));
    const Bgr colour = Hsv(hue + painter.Pick<double>({0.0, 0.08, 0.5, 0.58}),
                           painter.Uniform(0.2, 0.9), painter.Uniform(0.2, 1.0));
    const double size_m = painter.Uniform(0.05, 0.22) * unit_m;
    switch (painter.Integer(0, 3)) {
      case 0:
        painter.Disc(at_m, size_m, colour);
        painter.Disc(at_m, 0.6 * size_m, Mix(colour, main_colour, 0.6));
        break;
      case 1:
        painter.Rectangle(at_m.x, at_m.y, 1.6 * size_m, 0.7 * size_m, colour);
        break;
      case 2:
        painter.Fleck(at_m, 2.5 * size_m, colour);
        break;
      default:
        painter.Line({at_m, {painter.Uniform(0, w_m), painter.Uniform(0, h_m)}},
                     painter.Uniform(0.005, 0.03) * unit_m, colour);
    }
  }
}

void PaintScene(Painter& painter, const Bgr& colour) {
  painter.Pick<void (*)(Painter&, const Bgr&)>(
      {PaintLandscape, PaintStreet, PaintPortrait, PaintStillLife, PaintAbstract})(painter, colour);
}

std::string Words(Painter& painter, int count) {
  static const std::vector<std::string> kWords{
      "NORTH",  "COFFEE", "THE",    "RIVER",   "NIGHT", "GARDEN", "LIGHT", "OF",
      "SUMMER", "JAZZ",   "MUSEUM", "BLUE",    "CITY",  "MODERN", "ART",   "FESTIVAL",
      "ISLAND", "MOON",   "CINEMA", "ROAD",    "STORY", "WIND",   "HOUSE", "SCIENCE",
      "WORLD",  "SEA",    "STARS",  "HISTORY", "BREAD", "ATLAS"};
  const int words = static_cast<int>(kWords.size());
  std::string text;
  for (int i = 0, word = 0; i < count; ++i) {
    word = (word + painter.Integer(1, words - 1)) % words;  // never the same twice running
    text += (i > 0 ? " " : "") + kWords[word];
  }
  return text;
}

double LetterToFit(const Painter& painter, const std::string& text, double width_m,
                   double tallest_m) {
  return std::min(tallest_m, tallest_m * width_m / painter.TextWidth(tallest_m, text));
}

}  // namespace semantic_slam
