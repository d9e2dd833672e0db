#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "semantic_slam/worlds/pattern.h"
#include "semantic_slam/worlds/scenery.h"

namespace semantic_slam {
namespace {

// A text editor: coloured words in indented lines.
void PaintProgram(Painter& window) {
  const double w_m = window.width_m(), line_m = std::max(0.0075, 3 * window.texel_m());
  window.Fill(Bgr(40, 34, 30));
  window.Rectangle(0, 0, 0.03, window.height_m(), Bgr(52, 46, 42));
  int indent = 0;
  for (double y_m = 0.006; y_m + line_m < window.height_m(); y_m += line_m) {
    indent = std::clamp(indent + window.Integer(-1, 1), 0, 5);
    window.Rectangle(0.01, y_m + 0.2 * line_m, 0.01, 0.5 * line_m, Bgr::all(110));
    if (window.Chance(0.12)) continue;
    const double end_m = window.Uniform(0.3, 0.9) * w_m;
    for (double x_m = 0.04 + 0.015 * indent; x_m < end_m;) {
      const double word_m = window.Uniform(0.008, 0.035);
      window.Rectangle(x_m, y_m + 0.15 * line_m, word_m, 0.6 * line_m,
                       Hsv(window.Pick<double>({0.1, 0.33, 0.55, 0.8}), 0.5, 0.85));
      x_m += word_m + 0.005;
    }
  }
}

// A page with a heading, a picture and print.
void PaintPage(Painter& window, const Bgr& colour) {
  const double w_m = window.width_m(), h_m = window.height_m();
  window.Fill(Bgr::all(248));
  window.Rectangle(0, 0, w_m, 0.14 * h_m, colour * 0.7);
  const std::string heading = Words(window, 2);
  const double letter_m = LetterToFit(window, heading, 0.6 * w_m, 0.07 * h_m);
  window.Text(0.04 * w_m, 0.1 * h_m, letter_m, heading, Bgr::all(250));
  Painter photo = window.Part(0.05 * w_m, 0.2 * h_m, 0.42 * w_m, 0.4 * h_m);
  PaintScene(photo, Hsv(0.57, 0.4, 0.9));
  const double line_m = std::max(0.007, 3 * window.texel_m());
  window.Print(0.52 * w_m, 0.2 * h_m, 0.43 * w_m, 0.42 * h_m, line_m, Bgr::all(60));
  window.Print(0.05 * w_m, 0.65 * h_m, 0.9 * w_m, 0.32 * h_m, line_m, Bgr::all(60));
}

void PaintChart(Painter& window) {
  const double w_m = window.width_m(), h_m = window.height_m();
  window.Fill(Bgr(250, 248, 246));
  for (int i = 1; i < 6; ++i) {
    window.Rectangle(0.08 * w_m, i * h_m / 6, 0.88 * w_m, 0.001, Bgr::all(205));
  }
  const int bars = 9;
  const double hue = window.Uniform(0, 1);
  for (int i = 0; i < bars; ++i) {
    const double tall_m = window.Uniform(0.15, 0.75) * h_m;
    window.Rectangle((0.1 + 0.095 * i) * w_m, 0.92 * h_m - tall_m, 0.06 * w_m, tall_m,
                     Hsv(hue + 0.12 * (i % 3), 0.7, 0.8));
  }
}

void PaintWindow(Painter& desktop, double x_m, double y_m, double w_m, double h_m,
                 const Bgr& colour) {
  const double bar_m = 0.012;
  desktop.Rectangle(x_m - 0.002, y_m - 0.002, w_m + 0.004, h_m + 0.004, colour * 0.35);
  desktop.Rectangle(x_m, y_m, w_m, bar_m, Bgr(225, 222, 218));
  for (int i = 0; i < 3; ++i) {
    desktop.Disc({x_m + w_m - 0.008 - 0.011 * i, y_m + bar_m / 2}, 0.0035,
                 Hsv(0.0 + 0.14 * i, 0.7, 0.85));
  }
  desktop.Rectangle(x_m + 0.008, y_m + 0.3 * bar_m, 0.06, 0.4 * bar_m, Bgr::all(90));
  Painter window = desktop.Part(x_m, y_m + bar_m, w_m, h_m - bar_m);
  switch (desktop.Integer(0, 2)) {
    case 0:
      PaintProgram(window);
      break;
    case 1:
      PaintPage(window, colour);
      break;
    default:
      PaintChart(window);
  }
}

// A desktop of the main colour with windows, symbols and a task bar.
void PaintScreen(Painter& desktop, const Bgr& colour) {
  const double w_m = desktop.width_m(), h_m = desktop.height_m();
  PaintLandscape(desktop, colour);
  for (int i = 0; i < 6; ++i) {
    const double y_m = (0.04 + 0.14 * i) * h_m;
    desktop.Rectangle(0.02 * w_m, y_m, 0.016, 0.016, Hsv(desktop.Uniform(0, 1), 0.7, 0.9));
    desktop.Rectangle(0.02 * w_m, y_m + 0.02, 0.018, 0.003, Bgr::all(245));
  }
  PaintWindow(desktop, 0.1 * w_m, 0.06 * h_m, desktop.Uniform(0.4, 0.5) * w_m, 0.76 * h_m, colour);
  PaintWindow(desktop, desktop.Uniform(0.45, 0.55) * w_m, 0.16 * h_m, 0.42 * w_m,
              desktop.Uniform(0.5, 0.72) * h_m, colour);
  desktop.Rectangle(0, 0.93 * h_m, w_m, 0.07 * h_m, Bgr(48, 40, 36));
  for (int i = 0; i < 8; ++i) {
    desktop.Rectangle((0.01 + 0.045 * i) * w_m, 0.942 * h_m, 0.03 * w_m, 0.046 * h_m,
                      Hsv(desktop.Uniform(0, 1), 0.6, 0.85));
  }
  desktop.Text(0.9 * w_m, 0.985 * h_m, 0.035 * h_m, "12:45", Bgr::all(235));
}

void PaintKey(Painter& painter, double x_m, double y_m, double w_m, double h_m, const Bgr& cap,
              const std::string& legend) {
  painter.Rectangle(x_m, y_m, w_m, h_m, cap * 0.55);
  painter.Rectangle(x_m + 0.001, y_m + 0.001, w_m - 0.003, h_m - 0.004, cap);
  painter.Text(x_m + 0.003, y_m + 0.5 * h_m + 0.002, 0.006, legend, InkOn(cap));
}

const std::array<std::string, 5> kLegends{"1234567890-=", "QWERTYUIOP[]", "ASDFGHJKL;'#",
                                          "ZXCVBNM,./", ""};

// Rows of keys from `left_m` to `right_m`; the lowest has a space bar.
void PaintKeyBlock(Painter& painter, double left_m, double right_m, bool has_space_bar,
                   const Bgr& cap) {
  constexpr int kRows = 5;
  const double edge_m = 0.006, row_m = (painter.height_m() - 2 * edge_m) / kRows;
  const int keys = std::max(1, static_cast<int>((right_m - left_m) / 0.019));
  const double key_m = (right_m - left_m) / keys;
  for (int row = 0; row < kRows; ++row) {
    for (int key = 0; key < keys; ++key) {
      const bool is_space = has_space_bar && row == kRows - 1 && key == 4 && keys > 11;
      const double w_m = (is_space ? 6 : 1) * key_m - 0.002;
      const bool is_edge = has_space_bar && (key == 0 || key == keys - 1);
      const auto at = static_cast<std::size_t>(key - 1);
      const bool has_legend = !is_space && !is_edge && at < kLegends[row].size();
      const std::string legend = has_legend ? kLegends[row].substr(at, 1) : "";
      PaintKey(painter, left_m + key * key_m, edge_m + row * row_m, w_m, row_m - 0.002,
               is_edge ? cap * 0.8 : cap, legend);
      if (is_space) key += 5;
    }
  }
}

// Keys 19 mm apart on a case of the main colour; with a number pad if there is room.
void PaintKeyboard(Painter& painter, const Bgr& colour) {
  painter.Fill(colour);
  const Bgr cap = Luma(colour) > 110 ? colour * 0.8 : Mix(colour, Bgr::all(255), 0.16);
  const double w_m = painter.width_m();
  const double pad_m = w_m > 0.38 ? 0.08 : 0.0;
  PaintKeyBlock(painter, 0.008, w_m - 0.008 - (pad_m > 0 ? pad_m + 0.01 : 0.0), true, cap);
  if (pad_m > 0) PaintKeyBlock(painter, w_m - 0.008 - pad_m, w_m - 0.008, false, cap);
  painter.AddNoise(0.004, 4);  // worn
}

}  // namespace

PatternTable DevicePatterns() {
  return {{"screen", Picture(PaintScreen, 0.001)}, {"keyboard", Picture(PaintKeyboard, 0.001)}};
}

}  // namespace semantic_slam
