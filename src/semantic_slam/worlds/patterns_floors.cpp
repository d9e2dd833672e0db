
#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

// One block of a wooden floor, with grain along its longer side.
void PaintBlock(Painter& painter, const cv::Rect2d& block_m, const Bgr& wood) {
  constexpr double kGapM = 0.003;
  painter.Rectangle(block_m.x + kGapM, block_m.y + kGapM, block_m.width - kGapM,
                    block_m.height - kGapM, wood);
  const bool lies = block_m.width > block_m.height;
  for (int i = 0; i < 5; ++i) {
    const double across = painter.Uniform(0.12, 0.92);
    const double from = painter.Uniform(0.05, 0.5), to = painter.Uniform(from, 0.95);
    const auto place = [&](double along) {
      return cv::Point2d(block_m.x + block_m.width * (lies ? along : across),
                         block_m.y + block_m.height * (lies ? across : along));
    };
    painter.Line({place(from), place(to)}, 0.003, wood * painter.Uniform(0.8, 0.95));
  }
}

// Blocks of 0.32 m x 0.08 m that meet at right angles.
void PaintHerringbone(Painter& painter, const Bgr& colour) {
  constexpr int kCells = 32;  // a block is as wide as one and as long as kLong
  constexpr int kLong = 4;
  painter.Fill(colour * 0.45);
  const double step_x_m = painter.width_m() / kCells, step_y_m = painter.height_m() / kCells;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const int phase = (column - row + kCells) % (2 * kLong);
      const bool starts_lying = phase == 0, starts_upright = phase == 2 * kLong - 1;
      if (!starts_lying && !starts_upright) continue;
      const cv::Rect2d block_m(column * step_x_m, row * step_y_m,
                               step_x_m * (starts_lying ? kLong : 1),
                               step_y_m * (starts_lying ? 1 : kLong));
      PaintBlock(painter, block_m, painter.Near(colour, 26));
    }
  }
  painter.AddNoise(0.4, 5);
  painter.AddNoise(0.004, 6);
}

// Chips of stone in cement, ground flat.
void PaintTerrazzo(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  painter.AddNoise(0.2, 4);
  painter.Flecks(500, 0.012, 0.035, Mix(colour, Bgr::all(250), 0.55), 25);
  painter.Flecks(420, 0.01, 0.03, Mix(colour, Hsv(painter.Uniform(0, 0.12), 0.45, 0.5), 0.6), 30);
  painter.Flecks(380, 0.008, 0.025, colour * 0.45, 20);
  painter.Flecks(3000, 0.003, 0.006, colour * 0.75, 30);
  painter.AddNoise(0.003, 3);
}

// Squares of two tones in turn, 0.32 m wide.
void PaintCheckeredTiles(Painter& painter, const Bgr& colour) {
  const int tiles = 8;
  const double step_m = painter.width_m() / tiles;
  const Bgr other = Luma(colour) > 110 ? colour * 0.35 : Mix(colour, Bgr::all(245), 0.75);
  painter.Fill(Mix(colour, other, 0.5) * 0.8);
  for (int row = 0; row < tiles; ++row) {
    for (int column = 0; column < tiles; ++column) {
      const Bgr tone = painter.Near((row + column) % 2 == 0 ? colour : other, 8);
      painter.Rectangle(column * step_m, row * step_m, step_m - 0.004, step_m - 0.004, tone);
    }
  }
  painter.AddNoise(0.15, 6);
  painter.Flecks(500, 0.004, 0.016, colour * 0.9, 24);
  painter.AddNoise(0.004, 4);
}

// Squares of 0.5 m of looped yarn, whose stripes run along x and y in turn.
void PaintCarpetTiles(Painter& painter, const Bgr& colour) {
  const int tiles = 4, stripes = 20;
  const double step_m = painter.width_m() / tiles, stripe_m = step_m / stripes;
  const std::vector<Bgr> yarns{colour, colour * 0.8, colour * 0.65, Mix(colour, Bgr::all(255), 0.2),
                               Mix(colour, Hsv(painter.Uniform(0, 1), 0.5, 0.5), 0.4)};
  painter.Fill(colour);
  for (int tile = 0; tile < tiles * tiles; ++tile) {
    const double x_m = tile % tiles * step_m, y_m = tile / tiles * step_m;
    const bool upright = (tile % tiles + tile / tiles) % 2 == 0;
    for (int i = 0; i < stripes; ++i) {
      const double from = painter.Uniform(0, 0.6) * step_m;
      const double length_m = painter.Uniform(0.3, 1.0) * (step_m - from);
      const Bgr& yarn = painter.Pick(yarns);
      if (upright) painter.Rectangle(x_m + i * stripe_m, y_m + from, stripe_m, length_m, yarn);
      if (!upright) painter.Rectangle(x_m + from, y_m + i * stripe_m, length_m, stripe_m, yarn);
    }
  }
  painter.AddNoise(0.02, 7);
  painter.AddNoise(0.005, 12);
  painter.AddNoise(0.0025, 8);
}

}  // namespace

PatternTable FloorPatterns() {
  return {{"herringbone", Repeating(PaintHerringbone, 0.0025, {1024, 1024})},
          {"terrazzo", Repeating(PaintTerrazzo, 0.0025, {512, 512})},
          {"checkered_tiles", Repeating(PaintCheckeredTiles, 0.0025, {1024, 1024}, false)},
          {"carpet_tiles", Repeating(PaintCarpetTiles, 2.0 / 1024, {1024, 1024})}};
}

}  // namespace semantic_slam
