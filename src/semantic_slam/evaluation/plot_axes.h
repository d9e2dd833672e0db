#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/evaluation/plot_canvas.h"

namespace semantic_slam {

// A closed interval of data values.
struct PlotRange {
  double low = 0.0;
  double high = 0.0;

  double size() const { return high - low; }
  double centre() const { return 0.5 * (low + high); }
};

// The distance of ticks: 1, 2 or 5 times a power of ten, as small as lets at most `max_count` steps
// fit into `size`. Both more than 0.
double RoundStep(double size, int max_count);

// The multiples of `step` in `range`.
std::vector<double> RoundTicks(PlotRange range, double step);

// With just the decimals that tell ticks `step` apart: "0.25", "-3", never "-0".
std::string TickLabel(double value, double step);

// One coordinate system on a canvas: `area` is the box that data is drawn in, in the canvas's
// pixels; labels go outside of it. Where x and y have one scale, so has the grid. Not thread-safe;
// the canvas must outlive it.
class PlotAxes {
 public:
  PlotAxes(PlotCanvas& canvas, const cv::Rect2d& area, PlotRange x, PlotRange y);

  // Grid, frame, round ticks with numbers, and the three texts.
  void DrawFrame(const std::string& title, const std::string& x_label, const std::string& y_label);

  // Points in data coordinates. A polyline of one point is a dot.
  void DrawLine(const std::vector<cv::Point2d>& points, const cv::Scalar& colour, double width);
  // Dashed, across the area.
  void DrawHorizontal(double y, const cv::Scalar& colour, double width);
  cv::Point2d ToCanvas(cv::Point2d point) const;

 private:
  void DrawXTicks();
  double DrawYTicks();  // returns the width of the widest number [px]

  PlotCanvas& canvas_;
  const cv::Rect2d area_;
  const PlotRange x_;
  const PlotRange y_;
  double x_step_ = 0.0;  // between ticks
  double y_step_ = 0.0;
};

}  // namespace semantic_slam
