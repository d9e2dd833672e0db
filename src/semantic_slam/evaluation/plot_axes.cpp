#include "semantic_slam/evaluation/plot_axes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace semantic_slam {
namespace {

// In pixels; texts by the height of a capital letter.
constexpr double kTickSpacingX = 85.0;  // at least, so that numbers keep apart
constexpr double kTickSpacingY = 42.0;
constexpr double kTickText = 13.0;
constexpr double kLabelText = 14.0;
constexpr double kTitleText = 16.0;
const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kGrid(228, 228, 228);

int MaxSteps(double length_px, double spacing_px) {
  return std::max(2, static_cast<int>(length_px / spacing_px));
}

}  // namespace

double RoundStep(double size, int max_count) {
  assert(size > 0.0 && max_count > 0);
  const double finest = size / max_count;
  const double decade = std::pow(10.0, std::floor(std::log10(finest)));
  constexpr double kRounding = 1.0 + 1e-9;  // a step of 0.2 fits five times into 1.0
  for (const double digit : {1.0, 2.0, 5.0}) {
    if (digit * decade * kRounding >= finest) return digit * decade;
  }
  return 10.0 * decade;
}

std::vector<double> RoundTicks(PlotRange range, double step) {
  constexpr double kRounding = 1e-6;  // of a step
  std::vector<double> ticks;
  const double last = std::floor(range.high / step + kRounding);
  for (double i = std::ceil(range.low / step - kRounding); i <= last; i += 1.0) {
    ticks.push_back(i * step);
  }
  return ticks;
}

std::string TickLabel(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  if (std::abs(value) < 0.5 * step) value = 0.0;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

PlotAxes::PlotAxes(PlotCanvas& canvas, const cv::Rect2d& area, PlotRange x, PlotRange y)
    : canvas_(canvas), area_(area), x_(x), y_(y) {
  assert(x.size() > 0.0 && y.size() > 0.0);
  x_step_ = RoundStep(x_.size(), MaxSteps(area_.width, kTickSpacingX));
  y_step_ = RoundStep(y_.size(), MaxSteps(area_.height, kTickSpacingY));
  const double x_scale = area_.width / x_.size();
  const double y_scale = area_.height / y_.size();
  const bool is_equal_scale = std::abs(x_scale - y_scale) < 1e-6 * x_scale;
  if (is_equal_scale) x_step_ = y_step_ = std::max(x_step_, y_step_);  // a square grid
}

void PlotAxes::DrawFrame(const std::string& title, const std::string& x_label,
                         const std::string& y_label) {
  DrawXTicks();
  const double numbers_px = DrawYTicks();
  canvas_.Rectangle(area_, kInk, 1.0);
  const double centre_x = area_.x + 0.5 * area_.width;
  const double centre_y = area_.y + 0.5 * area_.height;
  canvas_.Text(title, {area_.x, area_.y - 13.0}, HorizontalAlign::kLeft, kTitleText, kInk);
  canvas_.Text(x_label, {centre_x, area_.br().y + 54.0}, HorizontalAlign::kCentre, kLabelText,
               kInk);
  canvas_.VerticalText(y_label, {area_.x - numbers_px - 30.0, centre_y}, kLabelText, kInk);
}

void PlotAxes::DrawXTicks() {
  for (const double value : RoundTicks(x_, x_step_)) {
    const double x_px = ToCanvas({value, y_.low}).x;
    canvas_.Line({x_px, area_.y}, {x_px, area_.br().y}, kGrid, 1.0);
    canvas_.Line({x_px, area_.br().y}, {x_px, area_.br().y - 6.0}, kInk, 1.0);
    canvas_.Text(TickLabel(value, x_step_), {x_px, area_.br().y + 24.0}, HorizontalAlign::kCentre,
                 kTickText, kInk);
  }
}

double PlotAxes::DrawYTicks() {
  double widest_px = 0.0;
  for (const double value : RoundTicks(y_, y_step_)) {
    const double y_px = ToCanvas({x_.low, value}).y;
    const std::string label = TickLabel(value, y_step_);
    canvas_.Line({area_.x, y_px}, {area_.br().x, y_px}, kGrid, 1.0);
    canvas_.Line({area_.x, y_px}, {area_.x + 6.0, y_px}, kInk, 1.0);
    canvas_.Text(label, {area_.x - 10.0, y_px + 0.5 * kTickText}, HorizontalAlign::kRight,
                 kTickText, kInk);
    widest_px = std::max(widest_px, PlotCanvas::TextWidth(label, kTickText));
  }
  return widest_px;
}

void PlotAxes::DrawLine(const std::vector<cv::Point2d>& points, const cv::Scalar& colour,
                        double width) {
  std::vector<cv::Point2d> on_canvas;
  on_canvas.reserve(points.size());
  for (const cv::Point2d& point : points) on_canvas.push_back(ToCanvas(point));
  if (on_canvas.size() == 1) {
    canvas_.Dot(on_canvas.front(), width + 1.0, colour);
  } else {
    canvas_.Polyline(on_canvas, colour, width);
  }
}

void PlotAxes::DrawHorizontal(double y, const cv::Scalar& colour, double width) {
  canvas_.DashedLine(ToCanvas({x_.low, y}), ToCanvas({x_.high, y}), colour, width);
}

cv::Point2d PlotAxes::ToCanvas(cv::Point2d point) const {
  return {area_.x + area_.width * (point.x - x_.low) / x_.size(),
          area_.br().y - area_.height * (point.y - y_.low) / y_.size()};
}

}  // namespace semantic_slam
