#include <cmath>

#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

// Cast in a formwork: clouds, pores, seams between boards and the holes of ties.
void PaintConcrete(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.7, 9);
  painter.AddNoise(0.15, 7);
  painter.AddNoise(0.02, 4);
  painter.Flecks(260, 0.004, 0.012, colour * 0.72, 14);
  const int panels = 2;
  const double step_x_m = painter.width_m() / panels, step_y_m = painter.height_m() / panels;
  for (int row = 0; row < panels; ++row) {
    painter.Rectangle(0, row * step_y_m, painter.width_m(), 0.006, colour * 0.8);
    painter.Rectangle(row * step_x_m, 0, 0.006, painter.height_m(), colour * 0.8);
    for (int column = 0; column < 2 * panels; ++column) {
      const cv::Point2d at_m((column + 0.5) * step_x_m / 2, (row + 0.5) * step_y_m);
      painter.Disc(at_m, 0.016, colour * 0.78);
      painter.Disc(at_m, 0.011, colour * 0.5);
    }
  }
  painter.AddNoise(0.004, 4);
}

// Broad and narrow upright stripes of two tones.
void PaintStripedWallpaper(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const int stripes = painter.Integer(10, 18);
  const double step_m = painter.width_m() / stripes;
  const Bgr second = Mix(colour, Hsv(painter.Uniform(0, 1), 0.4, 0.6), 0.4);
  const Bgr line = Mix(colour, Bgr::all(Luma(colour) > 110 ? 40 : 230), 0.35);
  const double share = painter.Uniform(0.3, 0.55);
  for (int i = 0; i < stripes; ++i) {
    painter.Rectangle(i * step_m, 0, share * step_m, painter.height_m(), second);
    painter.Rectangle((i + share + 0.08) * step_m, 0, 0.06 * step_m, painter.height_m(), line);
    painter.Rectangle((i + 0.9) * step_m, 0, 0.06 * step_m, painter.height_m(), line);
  }
  painter.AddNoise(0.02, 2.5);
  painter.AddNoise(0.0025, 3.0);
}

// Hexagons in rows, each with a smaller one inside, of a few tones.
void PaintHexagonWallpaper(Painter& painter, const Bgr& colour) {
  const Bgr accent = Mix(colour, Hsv(painter.Uniform(0, 1), 0.5, 0.6), 0.5);
  const std::vector<Bgr> tones{colour, colour * 0.85, Mix(colour, Bgr::all(255), 0.3), accent};
  painter.Fill(colour * 0.7);
  const int columns = 16, rows = 18;
  const cv::Point2d step(painter.width_m() / columns, painter.height_m() / rows);
  const auto hexagon = [&](const cv::Point2d& at_m, double scale, const Bgr& tone) {
    std::vector<cv::Point2d> corners_m;
    for (int i = 0; i < 6; ++i) {
      const double angle = CV_PI / 3 * i + CV_PI / 6;
      corners_m.push_back(at_m + scale * cv::Point2d(0.57 * step.x * std::cos(angle),
                                                     0.66 * step.y * std::sin(angle)));
    }
    painter.Polygon(corners_m, tone);
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const cv::Point2d at_m((column + 0.5 * (row % 2) + 0.1) * step.x, (row + 0.3) * step.y);
      hexagon(at_m, 0.94, painter.Pick(tones));
      hexagon(at_m, 0.5, painter.Pick(tones));
    }
  }
  painter.AddNoise(0.02, 2.5);
  painter.AddNoise(0.0025, 2.0);
}

// Boards on end with grooves between them, painted or of bare wood.
void PaintPanelling(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const int boards = 24;
  const double step_m = painter.width_m() / boards;
  for (int i = 0; i < boards; ++i) {
    const double x_m = i * step_m;
    painter.Rectangle(x_m, 0, step_m, painter.height_m(), painter.Near(colour, 7));
    painter.Rectangle(x_m, 0, 0.008, painter.height_m(), colour * 0.5);
    painter.Rectangle(x_m + 0.008, 0, 0.006, painter.height_m(), Mix(colour, Bgr::all(255), 0.25));
    painter.Rectangle(x_m + step_m - 0.006, 0, 0.006, painter.height_m(), colour * 0.82);
  }
  painter.Flecks(50, 0.004, 0.012, colour * 0.7, 15);
  painter.AddNoise(0.006, 0.7, 6);
}

// Glazed tiles of 0.2 m x 0.1 m in stretcher bond, each a little different.
void PaintSubwayTiles(Painter& painter, const Bgr& colour) {
  const Bgr grout = Luma(colour) > 110 ? colour * 0.68 : Mix(colour, Bgr::all(255), 0.35);
  painter.Fill(grout);
  const int columns = 13, rows = 26;
  const double step_x_m = painter.width_m() / columns, step_y_m = painter.height_m() / rows;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x_m = (column + 0.5 * (row % 2)) * step_x_m, y_m = row * step_y_m;
      const Bgr glaze = painter.Near(colour, 12);
      painter.Rectangle(x_m, y_m, step_x_m - 0.004, step_y_m - 0.004, glaze);
      painter.Rectangle(x_m + 0.004, y_m + 0.004, step_x_m - 0.012, 0.004,
                        Mix(glaze, Bgr::all(255), 0.4));
      painter.Rectangle(x_m, y_m + step_y_m - 0.008, step_x_m - 0.004, 0.004, glaze * 0.86);
    }
  }
  painter.AddNoise(0.03, 3);
  painter.AddNoise(0.004, 2);
}

// Squares of metal or gypsum, 0.6 m, with rows of holes.
void PaintPerforatedPanels(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const int panels = 4, holes = 16;
  const double step_m = painter.width_m() / panels;
  for (int panel = 0; panel < panels * panels; ++panel) {
    const cv::Point2d corner_m(panel % panels * step_m, panel / panels * step_m);
    for (int i = 0; i < holes * holes; ++i) {
      const cv::Point2d share((i % holes + 2.5) / (holes + 4), (i / holes + 2.5) / (holes + 4));
      painter.Disc(corner_m + step_m * share, 0.005, colour * 0.62);
    }
    painter.Rectangle(corner_m.x, corner_m.y, step_m, 0.008, colour * 0.8);
    painter.Rectangle(corner_m.x, corner_m.y, 0.008, step_m, colour * 0.8);
  }
  painter.AddNoise(0.3, 2.0);
  painter.AddNoise(0.005, 1.5);
}

}  // namespace

PatternTable WallPatterns() {
  return {{"concrete", Repeating(PaintConcrete, 0.0025, {1024, 1024})},
          {"striped_wallpaper", Repeating(PaintStripedWallpaper, 0.0025, {1024, 512})},
          {"hexagon_wallpaper", Repeating(PaintHexagonWallpaper, 0.0025, {1024, 1024})},
          {"panelling", Repeating(PaintPanelling, 0.0025, {1024, 512})},
          {"subway_tiles", Repeating(PaintSubwayTiles, 0.0025, {1024, 1024})},
          {"perforated_panels", Repeating(PaintPerforatedPanels, 2.4 / 1024, {1024, 1024})}};
}

}  // namespace semantic_slam
