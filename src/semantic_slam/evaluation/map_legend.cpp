#include "semantic_slam/evaluation/map_legend.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace semantic_slam {
namespace {

constexpr double kRow = 26.0;
constexpr double kText = 11.0;
const cv::Scalar kInk(40, 40, 40);

}  // namespace

void DrawLegend(const std::vector<LegendEntry>& entries, cv::Point2d top_left, double height,
                PlotCanvas& canvas) {
  double y = top_left.y + 0.5 * kRow;
  for (const LegendEntry& entry : entries) {
    if (y + 0.5 * kRow > top_left.y + height) return;
    canvas.Square({top_left.x + 8.0, y}, 8.0, entry.colour);
    canvas.Text(entry.name, {top_left.x + 26.0, y + 0.5 * kText}, HorizontalAlign::kLeft, kText,
                kInk);
    y += kRow;
  }
}

void DrawScaleBar(double pixels_per_metre, double room_px, cv::Point2d left_end,
                  PlotCanvas& canvas) {
  const double longest_m = room_px / pixels_per_metre;
  const double decade = std::pow(10.0, std::floor(std::log10(longest_m)));
  double length_m = decade;
  for (const double factor : {2.0, 5.0}) {
    if (factor * decade <= longest_m) length_m = factor * decade;
  }
  const cv::Point2d right_end(left_end.x + length_m * pixels_per_metre, left_end.y);
  canvas.Line(left_end, right_end, kInk, 3.0);
  for (const cv::Point2d& end : {left_end, right_end}) {
    canvas.Line(end - cv::Point2d(0.0, 6.0), end + cv::Point2d(0.0, 6.0), kInk, 3.0);
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g m", length_m);
  canvas.Text(text.data(), right_end + cv::Point2d(12.0, 0.5 * kText), HorizontalAlign::kLeft,
              kText, kInk);
}

}  // namespace semantic_slam
