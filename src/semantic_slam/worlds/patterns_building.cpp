#include <algorithm>
#include <cmath>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

void PaintPlaster(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.6, 2.5);
  painter.AddNoise(0.06, 1.5);
  painter.AddNoise(0.008, 1.5);
}

// A flower of the wallpaper with its stalk and leaves.
void PaintFlower(Painter& painter, const cv::Point2d& at_m, double size_m, const Bgr& petal,
                 const Bgr& leaf) {
  const double lean = painter.Uniform(-0.5, 0.5);
  const auto place = [&](double along, double across) {
    return at_m + size_m * cv::Point2d(along * std::sin(lean) + across * std::cos(lean),
                                       along * std::cos(lean) - across * std::sin(lean));
  };
  painter.Line({place(0, 0), place(0.5, 0.1), place(1.2, -0.1), place(1.9, 0.15)}, 0.06 * size_m,
               leaf);
  for (int i = 0; i < 4; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    painter.Ellipse(place(0.75 + 0.28 * i, 0.3 * side), 0.3 * size_m, 0.11 * size_m, leaf,
                    -lean + side * painter.Uniform(0.3, 0.9));
  }
  const int petals = painter.Integer(5, 8);
  for (int i = 0; i < petals; ++i) {
    const double angle = 2 * CV_PI * i / petals + lean;
    painter.Ellipse(at_m + 0.32 * size_m * cv::Point2d(std::cos(angle), std::sin(angle)),
                    0.3 * size_m, 0.15 * size_m, painter.Near(petal, 12), angle);
  }
  painter.Disc(at_m, 0.13 * size_m, leaf);
}

// Flowers in staggered rows between fine stripes.
void PaintWallpaper(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const int columns = 16, rows = 16;
  const double step_x_m = painter.width_m() / columns, step_y_m = painter.height_m() / rows;
  const Bgr dark = Mix(colour, Bgr::all(0), 0.16), pale = Mix(colour, Bgr::all(255), 0.35);
  const Bgr petal = Mix(colour, Hsv(painter.Uniform(0.0, 1.0), 0.55, 0.65), 0.55);
  const Bgr leaf = Mix(colour, Hsv(painter.Uniform(0.2, 0.45), 0.4, 0.35), 0.5);
  for (int column = 0; column < columns; ++column) {
    painter.Rectangle((column + 0.08) * step_x_m, 0, 0.03 * step_x_m, painter.height_m(), pale);
    painter.Rectangle((column + 0.92) * step_x_m, 0, 0.03 * step_x_m, painter.height_m(), dark);
    for (int row = 0; row < rows; ++row) {
      const double y_m = (row + (column % 2 == 0 ? 0.15 : 0.65)) * step_y_m;
      const cv::Point2d at_m((column + 0.5 + painter.Uniform(-0.08, 0.08)) * step_x_m, y_m);
      PaintFlower(painter, at_m, painter.Uniform(0.034, 0.052), painter.Near(petal, 25), leaf);
    }
  }
  painter.AddNoise(0.02, 2.5);
  painter.AddNoise(0.0025, 2.0);
}

// Stretcher bond, 0.25 m x 1/12 m with its joints.
void PaintBrick(Painter& painter, const Bgr& colour) {
  const Bgr mortar = Mix(Bgr(165, 172, 178), colour, 0.15);
  painter.Fill(mortar);
  painter.AddNoise(0.01, 14);
  const int rows = 30, columns = 10;
  const double length_m = painter.width_m() / columns, height_m = painter.height_m() / rows;
  const double joint_m = 0.011;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x_m = (column + (row % 2) * 0.5) * length_m + painter.Uniform(-0.002, 0.002);
      const double y_m = row * height_m + painter.Uniform(-0.001, 0.001);
      Bgr clay = painter.Near(colour, 26);
      if (painter.Chance(0.1)) clay = clay * 0.6;  // burnt
      const auto worn = [&] { return painter.Uniform(-0.002, 0.002); };
      const double right_m = x_m + length_m - joint_m, low_m = y_m + height_m - joint_m;
      painter.Polygon({{x_m + worn(), y_m + worn()},
                       {right_m + worn(), y_m + worn()},
                       {right_m + worn(), low_m + worn()},
                       {x_m + worn(), low_m + worn()}},
                      clay);
      if (painter.Chance(0.35)) {  // a chip
        painter.Fleck({x_m + painter.Uniform(0.0, length_m), y_m}, painter.Uniform(0.008, 0.025),
                      mortar * 0.9);
      }
    }
  }
  painter.Flecks(350, 0.004, 0.014, colour * 0.6, 35);
  painter.AddNoise(0.006, 12);
  painter.AddNoise(0.05, 6);
}

// Mineral fibre in a grid of 0.6 m: pale, with fine holes.
void PaintCeilingTiles(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.Flecks(900, 0.003, 0.007, colour * 0.95, 3);
  const int tiles = cvRound(painter.width_m() / 0.6);
  const double step_m = painter.width_m() / tiles;
  for (int i = 0; i < tiles; ++i) {
    for (const bool upright : {false, true}) {
      const auto bar = [&](double from_m, double to_m, const Bgr& bar_colour) {
        const double at_m = i * step_m + from_m, thick_m = to_m - from_m;
        if (upright) painter.Rectangle(at_m, 0, thick_m, painter.height_m(), bar_colour);
        if (!upright) painter.Rectangle(0, at_m, painter.width_m(), thick_m, bar_colour);
      };
      bar(0.0, 0.024, Mix(colour, Bgr::all(255), 0.3));
      bar(0.024, 0.029, colour * 0.84);
    }
  }
  painter.AddNoise(0.25, 2.0);
  painter.AddNoise(0.005, 1.5);
}

// Ceramic, 0.32 m square, with cloudy glaze.
void PaintTiles(Painter& painter, const Bgr& colour) {
  const int tiles = 8;
  const double step_m = painter.width_m() / tiles, joint_m = 0.005;
  const Bgr grout = Luma(colour) > 90 ? colour * 0.62 : Mix(colour, Bgr::all(255), 0.3);
  painter.Fill(colour);
  painter.AddNoise(0.12, 7);
  painter.AddNoise(0.03, 7);
  painter.Flecks(1500, 0.004, 0.014, colour * 0.9, 22);
  for (int row = 0; row < tiles; ++row) {
    for (int column = 0; column < tiles; ++column) {
      const double x_m = column * step_m, y_m = row * step_m;
      Painter tile = painter.Part(x_m, y_m, step_m, step_m);
      tile.AddGrey(cv::Mat1f(tile.size_px(), static_cast<float>(painter.Uniform(-7, 7))));
      tile.Rectangle(0, 0, step_m, joint_m, grout);
      tile.Rectangle(0, 0, joint_m, step_m, grout);
      tile.Rectangle(joint_m, joint_m, step_m - joint_m, 0.003, Mix(colour, Bgr::all(255), 0.25));
    }
  }
  painter.AddNoise(0.005, 3);
}

// Veins are where smooth noise crosses zero.
cv::Mat1f Veins(Painter& painter, double size_m, double sharpness) {
  const cv::Mat1f noise = painter.Noise(size_m, 0.6 * size_m) + 0.5 * painter.Noise(size_m / 3) +
                          0.2 * painter.Noise(size_m / 9);
  cv::Mat1f veins = 1.0 - sharpness * cv::abs(noise);
  return cv::max(veins, 0.0);
}

void PaintMarble(Painter& painter, const Bgr& colour) {
  const bool is_pale = Luma(colour) > 110;
  const Bgr vein =
      is_pale ? Mix(colour, Hsv(0.09, 0.15, 0.25), 0.65) : Mix(colour, {215, 222, 228}, 0.55);
  painter.Fill(colour);
  painter.AddNoise(0.3, 10);
  painter.AddNoise(0.08, 6);
  painter.Glaze(Mix(colour, vein, 0.5), 0.6 * Veins(painter, 0.35, 4));
  painter.Glaze(vein, 0.9 * Veins(painter, 0.4, 12));
  painter.Glaze(vein, 0.6 * Veins(painter, 0.16, 9));
  painter.AddNoise(0.012, 4);
  painter.AddNoise(0.0025, 3);
}

}  // namespace

PatternTable BuildingPatterns() {
  return {{"plaster", Repeating(PaintPlaster, 0.004, {512, 512})},
          {"wallpaper", Repeating(PaintWallpaper, 0.0025, {1024, 1024})},
          {"brick", Repeating(PaintBrick, 2.5 / 1024, {1024, 1024}, false)},
          {"ceiling_tiles", Repeating(PaintCeilingTiles, 2.4 / 1024, {1024, 1024})},
          {"tiles", Repeating(PaintTiles, 0.0025, {1024, 1024})},
          {"marble", Repeating(PaintMarble, 0.0025, {512, 512})}};
}

}  // namespace semantic_slam
