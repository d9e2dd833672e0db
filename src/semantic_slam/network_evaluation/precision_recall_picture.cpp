#include "semantic_slam/network_evaluation/precision_recall_picture.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include <opencv2/imgproc.hpp>

#include "semantic_slam/evaluation/map_legend.h"
#include "semantic_slam/evaluation/plot_axes.h"
#include "semantic_slam/evaluation/plot_canvas.h"

namespace semantic_slam {
namespace {

// The layout, in pixels.
const cv::Size kPage(1080, 800);
const cv::Rect2d kArea(90.0, 60.0, 640.0, 640.0);
constexpr double kLegendX = 760.0;
constexpr std::size_t kMostCurves = 23;  // that the legend has room for, beside the mean
constexpr int kRecallSteps = 500;        // of the mean
const cv::Scalar kInk(40, 40, 40);

struct ClassCurve {
  std::string name;
  double ap = 0.0;
  std::vector<CurvePoint> curve;
};

std::string WithValue(const std::string& name, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "  %.3f", value);
  return name + text.data();
}

// Told apart by hue and, beyond a few, by brightness.
cv::Scalar CurveColour(std::size_t i, std::size_t count) {
  const auto hue = static_cast<std::uint8_t>(180 * i / std::max<std::size_t>(count, 1));
  const std::uint8_t value = i % 2 == 0 ? 210 : 150;
  cv::Mat pixel(1, 1, CV_8UC3, cv::Scalar(hue, 210, value));
  cv::cvtColor(pixel, pixel, cv::COLOR_HSV2BGR);
  const cv::Vec3b bgr = pixel.at<cv::Vec3b>(0);
  return {static_cast<double>(bgr[0]), static_cast<double>(bgr[1]), static_cast<double>(bgr[2])};
}

std::vector<ClassCurve> CurvesByAp(const DetectionScore& score,
                                   const std::vector<std::string>& names) {
  std::vector<ClassCurve> curves;
  for (int c = 0; c < score.classes(); ++c) {
    if (score.truths(c) == 0) continue;
    std::vector<CurvePoint> curve = score.Curve(c);
    const double ap = AveragePrecision(curve, score.truths(c));
    curves.push_back({names[c], ap, std::move(curve)});
  }
  std::stable_sort(curves.begin(), curves.end(),
                   [](const ClassCurve& a, const ClassCurve& b) { return a.ap > b.ap; });
  return curves;
}

std::vector<cv::Point2d> PointsOf(const std::vector<CurvePoint>& curve) {
  const std::vector<double> envelope = PrecisionEnvelope(curve);
  std::vector<cv::Point2d> points;
  double recall = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    points.emplace_back(recall, envelope[i]);  // steps, whose area is the AP
    recall = curve[i].rates.recall();
    points.emplace_back(recall, envelope[i]);
  }
  if (!points.empty()) points.emplace_back(recall, 0.0);
  return points;
}

double PrecisionAt(double recall, const std::vector<CurvePoint>& curve,
                   const std::vector<double>& envelope) {
  const auto reached =
      std::lower_bound(curve.begin(), curve.end(), recall,
                       [](const CurvePoint& point, double r) { return point.rates.recall() < r; });
  return reached == curve.end() ? 0.0 : envelope[reached - curve.begin()];
}

std::vector<cv::Point2d> MeanPoints(const std::vector<ClassCurve>& curves) {
  std::vector<double> sums(kRecallSteps + 1, 0.0);
  for (const ClassCurve& each : curves) {
    const std::vector<double> envelope = PrecisionEnvelope(each.curve);
    for (int i = 0; i <= kRecallSteps; ++i) {
      sums[i] += PrecisionAt(static_cast<double>(i) / kRecallSteps, each.curve, envelope);
    }
  }
  std::vector<cv::Point2d> points;
  for (int i = 0; i <= kRecallSteps; ++i) {
    points.emplace_back(static_cast<double>(i) / kRecallSteps,
                        sums[i] / static_cast<double>(curves.size()));
  }
  return points;
}

}  // namespace

cv::Mat DrawPrecisionRecall(const DetectionScore& score, const std::vector<std::string>& names) {
  const std::vector<ClassCurve> curves = CurvesByAp(score, names);
  PlotCanvas canvas(kPage);
  PlotAxes axes(canvas, kArea, {0.0, 1.0}, {0.0, 1.0});
  axes.DrawFrame("Precision over recall, IoU 0.5", "recall", "precision");
  const std::size_t shown = std::min(curves.size(), kMostCurves);
  std::vector<LegendEntry> legend;
  if (!curves.empty()) legend.push_back({WithValue("mean", score.MeanAp50()), kInk});
  for (std::size_t i = 0; i < shown; ++i) {
    const cv::Scalar colour = CurveColour(i, shown);
    axes.DrawLine(PointsOf(curves[i].curve), colour, 1.5);
    legend.push_back({WithValue(curves[i].name, curves[i].ap), colour});
  }
  if (!curves.empty()) axes.DrawLine(MeanPoints(curves), kInk, 3.0);
  DrawLegend(legend, {kLegendX, kArea.y}, kArea.height, canvas);
  return canvas.Image();
}

}  // namespace semantic_slam
