#include "semantic_slam/evaluation/trajectory_plot.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "semantic_slam/common/atomic_file.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/evaluation/plot_axes.h"
#include "semantic_slam/evaluation/plot_canvas.h"

namespace semantic_slam {
namespace {

// Colours (BGR) that stay apart for colour-blind eyes (Okabe and Ito, 2008).
const cv::Scalar kBlue(178, 114, 0);
const cv::Scalar kVermilion(0, 94, 213);
const cv::Scalar kGreen(115, 158, 0);
const cv::Scalar kGrey(150, 150, 150);
const cv::Scalar kInk(40, 40, 40);

// The layout, in pixels. Two square-ish views stand side by side above one wide curve.
constexpr double kWidth = 1600.0;
constexpr double kLeft = 115.0;     // of a box: tick numbers and a label
constexpr double kRight = 30.0;     // of the page
constexpr double kHeader = 118.0;   // legend and the views' titles
constexpr double kBetween = 122.0;  // ticks, label, the next title
constexpr double kCurveHeight = 230.0;
constexpr double kFooter = 74.0;
constexpr double kViewWidth = 0.5 * (kWidth - 2.0 * kLeft - kRight);
constexpr double kText = 15.0;
constexpr double kMarker = 7.0;
constexpr double kReferenceWidth = 5.0;
constexpr double kEstimateWidth = 2.0;

using Points = std::vector<cv::Point2d>;
using Projection = std::function<cv::Point2d(const StampedPose&)>;

cv::Point2d TopView(const StampedPose& stamped) {
  return {stamped.pose.translation().x(), stamped.pose.translation().y()};
}

cv::Point2d SideView(const StampedPose& stamped) {
  return {stamped.pose.translation().x(), stamped.pose.translation().z()};
}

template <typename... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

// A longer silence than this means that poses are missing: a second, or five times what is usual.
double GapSeconds(const std::vector<Stamp>& stamps) {
  std::vector<double> intervals_s;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    intervals_s.push_back(SecondsBetween(stamps[i - 1], stamps[i]));
  }
  if (intervals_s.empty()) return 1.0;
  const auto middle = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
  std::nth_element(intervals_s.begin(), middle, intervals_s.end());
  return std::max(1.0, 5.0 * *middle);
}

// `points` are parallel to `stamps`.
void DrawCurve(const std::vector<Stamp>& stamps, const Points& points, const cv::Scalar& colour,
               double width, PlotAxes& axes) {
  const double gap_s = GapSeconds(stamps);
  Points piece;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && SecondsBetween(stamps[i - 1], stamps[i]) > gap_s) {
      axes.DrawLine(piece, colour, width);
      piece.clear();
    }
    piece.push_back(points[i]);
  }
  if (!piece.empty()) axes.DrawLine(piece, colour, width);
}

std::vector<Stamp> Stamps(const Trajectory& trajectory) {
  std::vector<Stamp> stamps;
  for (const StampedPose& stamped : trajectory) stamps.push_back(stamped.stamp);
  return stamps;
}

Points Projected(const Trajectory& trajectory, const Projection& projection) {
  Points points;
  for (const StampedPose& stamped : trajectory) points.push_back(projection(stamped));
  return points;
}

struct Bounds {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d high = -low;

  void Include(const Trajectory& trajectory) {
    for (const StampedPose& stamped : trajectory) {
      low = low.min(stamped.pose.translation().array());
      high = high.max(stamped.pose.translation().array());
    }
  }
};

// Both boxes have one height, as much as their data needs. Each view has one scale for both axes.
struct ViewLayout {
  struct View {
    PlotRange x;
    PlotRange upright;
  };

  explicit ViewLayout(const Bounds& bounds) {
    constexpr double kMargin = 1.12;
    constexpr double kMinExtent = 0.02;  // [m], a sensor that stood still
    const Eigen::Array3d centre = 0.5 * (bounds.low + bounds.high);
    const Eigen::Array3d extent = (kMargin * (bounds.high - bounds.low)).max(kMinExtent);
    const double aspect = std::max(extent.y(), extent.z()) / extent.x();
    height = kViewWidth * std::clamp(aspect, 0.5, 1.0);
    const auto view = [&](int axis) {
      const double metres_per_px = std::max(extent.x() / kViewWidth, extent[axis] / height);
      return View{Centred(centre.x(), metres_per_px * kViewWidth),
                  Centred(centre[axis], metres_per_px * height)};
    };
    top = view(1);
    side = view(2);
  }

  static PlotRange Centred(double centre, double size) {
    return {centre - 0.5 * size, centre + 0.5 * size};
  }

  double height = 0.0;  // [px]
  View top;
  View side;
};

// Symbols and their names from left to right, centred on a line.
class Legend {
 public:
  Legend(PlotCanvas& canvas, cv::Point2d start) : canvas_(canvas), at_(start) {}

  void AddLine(const std::string& name, const cv::Scalar& colour, double width) {
    canvas_.Line(at_, LineEnd(), colour, width);
    AddName(name, kLineLength);
  }
  void AddDashedLine(const std::string& name, const cv::Scalar& colour, double width) {
    canvas_.DashedLine(at_, LineEnd(), colour, width);
    AddName(name, kLineLength);
  }
  void AddEnds() {
    canvas_.Dot(at_ + cv::Point2d(kMarker, 0.0), kMarker, kGreen);
    AddName("start", 2.0 * kMarker);
    canvas_.Square(at_ + cv::Point2d(kMarker, 0.0), kMarker, kVermilion);
    AddName("end", 2.0 * kMarker);
  }

 private:
  static constexpr double kLineLength = 44.0;

  cv::Point2d LineEnd() const { return {at_.x + kLineLength, at_.y}; }

  void AddName(const std::string& name, double symbol_width) {
    at_.x += symbol_width + 10.0;
    canvas_.Text(name, at_ + cv::Point2d(0.0, 0.5 * kText), HorizontalAlign::kLeft, kText, kInk);
    at_.x += PlotCanvas::TextWidth(name, kText) + 34.0;
  }

  PlotCanvas& canvas_;
  cv::Point2d at_;
};

// A page with the two views drawn and room for the curve.
class Figure {
 public:
  explicit Figure(const Bounds& bounds)
      : layout_(bounds),
        curve_top_(kHeader + layout_.height + kBetween),
        canvas_({cvRound(kWidth), cvRound(curve_top_ + kCurveHeight + kFooter)}),
        top_(canvas_, {kLeft, kHeader, kViewWidth, layout_.height}, layout_.top.x,
             layout_.top.upright),
        side_(canvas_, {2.0 * kLeft + kViewWidth, kHeader, kViewWidth, layout_.height},
              layout_.side.x, layout_.side.upright) {
    top_.DrawFrame("Top view", "x [m]", "y [m]");
    side_.DrawFrame("Side view", "x [m]", "z [m]");
  }

  void DrawPath(const Trajectory& trajectory, const cv::Scalar& colour, double width) {
    const std::vector<Stamp> stamps = Stamps(trajectory);
    DrawCurve(stamps, Projected(trajectory, TopView), colour, width, top_);
    DrawCurve(stamps, Projected(trajectory, SideView), colour, width, side_);
  }

  void MarkEnds(const Trajectory& trajectory) {
    for (auto& [axes, projection] : {std::pair<PlotAxes&, Projection>(top_, TopView),
                                     std::pair<PlotAxes&, Projection>(side_, SideView)}) {
      canvas_.Dot(axes.ToCanvas(projection(trajectory.front())), kMarker, kGreen);
      canvas_.Square(axes.ToCanvas(projection(trajectory.back())), kMarker, kVermilion);
    }
  }

  PlotAxes CurveAxes(PlotRange time_s, PlotRange value) {
    return PlotAxes(canvas_, {kLeft, curve_top_, kWidth - kLeft - kRight, kCurveHeight}, time_s,
                    value);
  }

  void SetSummary(const std::string& text) {
    canvas_.Text(text, {kWidth - kRight, kLegendY + 0.5 * kText}, HorizontalAlign::kRight, kText,
                 kInk);
  }

  Legend PathLegend() { return {canvas_, {kLeft, kLegendY}}; }
  Legend CurveLegend() { return {canvas_, {kLeft + 220.0, curve_top_ - 20.0}}; }  // after the title
  cv::Mat Image() const { return canvas_.Image(); }

 private:
  static constexpr double kLegendY = 38.0;

  const ViewLayout layout_;
  const double curve_top_;
  PlotCanvas canvas_;
  PlotAxes top_;
  PlotAxes side_;
};

Trajectory Moved(const Trajectory& trajectory, const Rigid3d& T_target_source) {
  Trajectory moved = trajectory;
  for (StampedPose& stamped : moved) stamped.pose = T_target_source * stamped.pose;
  return moved;
}

double PathLength(const Trajectory& trajectory) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length_m += (trajectory[i].pose.translation() - trajectory[i - 1].pose.translation()).norm();
  }
  return length_m;
}

PlotRange TimeRange(const Trajectory& trajectory) {
  const double end_s = SecondsBetween(trajectory.front().stamp, trajectory.back().stamp);
  return {0.0, end_s > 0.0 ? end_s : 1.0};
}

void DrawErrorCurve(const Trajectory& estimate, const TrajectoryReport& report, Figure& figure) {
  const ErrorStatistics statistics = Summarise(report.absolute.position_m);
  constexpr double kMinRange = 1e-3;  // [m], a perfect estimate
  PlotAxes axes =
      figure.CurveAxes(TimeRange(estimate), {0.0, std::max(1.15 * statistics.max, kMinRange)});
  axes.DrawFrame("Position error", "time [s]", "error [m]");
  std::vector<Stamp> stamps;
  Points points;
  for (std::size_t i = 0; i < report.matches.size(); ++i) {
    stamps.push_back(report.matches[i].stamp);
    points.emplace_back(SecondsBetween(estimate.front().stamp, stamps.back()),
                        report.absolute.position_m[i]);
  }
  DrawCurve(stamps, points, kBlue, kEstimateWidth, axes);
  axes.DrawHorizontal(statistics.rmse, kVermilion, kEstimateWidth);
  figure.CurveLegend().AddDashedLine("RMSE", kVermilion, kEstimateWidth);
}

void DrawPositionCurves(const Trajectory& estimate, const Bounds& bounds, Figure& figure) {
  const double low = bounds.low.minCoeff();
  const double high = bounds.high.maxCoeff();
  const double margin = std::max(0.08 * (high - low), 0.01);
  PlotAxes axes = figure.CurveAxes(TimeRange(estimate), {low - margin, high + margin});
  axes.DrawFrame("Position", "time [s]", "position [m]");
  const std::array<cv::Scalar, 3> colours = {kVermilion, kGreen, kBlue};
  const std::vector<Stamp> stamps = Stamps(estimate);
  const std::array<const char*, 3> names = {"x", "y", "z"};
  Legend legend = figure.CurveLegend();
  for (int axis = 0; axis < 3; ++axis) {
    const Points points = Projected(estimate, [&](const StampedPose& stamped) {
      return cv::Point2d(SecondsBetween(estimate.front().stamp, stamped.stamp),
                         stamped.pose.translation()[axis]);
    });
    DrawCurve(stamps, points, colours[axis], kEstimateWidth, axes);
    legend.AddLine(names[axis], colours[axis], kEstimateWidth);
  }
}

}  // namespace

cv::Mat PlotComparison(const Trajectory& reference, const Trajectory& estimate,
                       const TrajectoryReport& report) {
  assert(!reference.empty() && !estimate.empty());
  const Trajectory aligned = Moved(estimate, report.T_reference_estimate);
  Bounds bounds;
  bounds.Include(reference);
  bounds.Include(aligned);
  Figure figure(bounds);
  figure.DrawPath(reference, kGrey, kReferenceWidth);
  figure.DrawPath(aligned, kBlue, kEstimateWidth);
  figure.MarkEnds(aligned);
  DrawErrorCurve(estimate, report, figure);
  Legend legend = figure.PathLegend();
  legend.AddLine("reference", kGrey, kReferenceWidth);
  legend.AddLine("estimate, aligned", kBlue, kEstimateWidth);
  legend.AddEnds();
  figure.SetSummary(Format("ATE RMSE %.4f m, path %.2f m, %zu poses matched",
                           Summarise(report.absolute.position_m).rmse, report.path_m,
                           report.matches.size()));
  return figure.Image();
}

cv::Mat PlotTrajectory(const Trajectory& estimate) {
  assert(!estimate.empty());
  Bounds bounds;
  bounds.Include(estimate);
  Figure figure(bounds);
  figure.DrawPath(estimate, kBlue, kEstimateWidth);
  figure.MarkEnds(estimate);
  DrawPositionCurves(estimate, bounds, figure);
  Legend legend = figure.PathLegend();
  legend.AddLine("estimate", kBlue, kEstimateWidth);
  legend.AddEnds();
  figure.SetSummary(Format("path %.2f m, %zu poses", PathLength(estimate), estimate.size()));
  return figure.Image();
}

void CheckPlotPath(const std::string& path) {
  if (std::filesystem::path(path).extension() == ".png") return;
  throw ConfigError("plot = " + path + ", but must end in .png");
}

void WritePlot(const cv::Mat& plot, const std::string& path) {
  CheckPlotPath(path);
  WriteFileAtomicallyVia(
      path, [&](const std::string& temporary_path) { return cv::imwrite(temporary_path, plot); });
}

}  // namespace semantic_slam
