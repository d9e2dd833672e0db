#include "semantic_slam/network_evaluation/detection_score.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace semantic_slam {
namespace {

double IouOfStep(int step) {
  return kMatchIou + 0.05 * step;
}

std::vector<cv::Rect2f> BoxesOf(const std::vector<ClassBox>& boxes, int class_index) {
  std::vector<cv::Rect2f> selected;
  for (const ClassBox& box : boxes) {
    if (box.class_index == class_index) selected.push_back(box.box);
  }
  return selected;
}

// Of the values that are numbers; NaN without any.
double MeanOfDefined(int count, const std::function<double(int)>& value) {
  double sum = 0.0;
  int defined = 0;
  for (int i = 0; i < count; ++i) {
    const double one = value(i);
    if (std::isnan(one)) continue;
    sum += one;
    ++defined;
  }
  return sum / defined;  // 0 / 0 is NaN, as it should be
}

}  // namespace

DetectionScore::DetectionScore(std::size_t classes, double threshold)
    : threshold_(threshold), found_(classes), truths_(classes, 0) {}

DetectionRates DetectionScore::Add(const std::vector<ClassBox>& truth,
                                   const std::vector<ClassBox>& found) {
  DetectionRates image;
  for (const ClassBox& box : truth) ++truths_[box.class_index];
  for (int c = 0; c < classes(); ++c) {
    for (const FoundBox& box : Match(truth, found, c)) {
      found_[c].push_back(box);
      if (static_cast<double>(box.confidence) < threshold_) continue;
      ++((box.hits & 1u) != 0 ? image.hits : image.extras);
    }
  }
  image.misses = static_cast<std::int64_t>(truth.size()) - image.hits;
  return image;
}

std::vector<DetectionScore::FoundBox> DetectionScore::Match(const std::vector<ClassBox>& truth,
                                                            const std::vector<ClassBox>& found,
                                                            int class_index) const {
  std::vector<FoundBox> matched;
  for (const ClassBox& box : found) {
    if (box.class_index == class_index) matched.push_back({box.confidence, 0});
  }
  if (matched.empty()) return matched;
  const std::vector<cv::Rect2f> true_boxes = BoxesOf(truth, class_index);
  const std::vector<cv::Rect2f> found_boxes = BoxesOf(found, class_index);
  for (int step = 0; step < kIouSteps; ++step) {
    const std::vector<int> taken = MatchInOrder(true_boxes, found_boxes, IouOfStep(step));
    for (std::size_t i = 0; i < matched.size(); ++i) {
      if (taken[i] >= 0) matched[i].hits |= static_cast<std::uint16_t>(1u << step);
    }
  }
  return matched;
}

ClassDetectionScore DetectionScore::OfClass(int class_index) const {
  return {truths_[class_index], ApAt(class_index, 0), ApOverSteps(class_index),
          RatesAt(class_index, threshold_)};
}

std::vector<CurvePoint> DetectionScore::Curve(int class_index) const {
  return CurveAt(class_index, 0);
}

std::vector<CurvePoint> DetectionScore::CurveAt(int class_index, int iou_step) const {
  std::vector<ScoredHit> hits;
  hits.reserve(found_[class_index].size());
  for (const FoundBox& box : found_[class_index]) {
    hits.push_back({box.confidence, ((box.hits >> iou_step) & 1u) != 0});
  }
  return PrecisionRecallCurve(std::move(hits), truths_[class_index]);
}

double DetectionScore::ApAt(int class_index, int iou_step) const {
  return AveragePrecision(CurveAt(class_index, iou_step), truths_[class_index]);
}

double DetectionScore::ApOverSteps(int class_index) const {
  return MeanOfDefined(kIouSteps, [&](int step) { return ApAt(class_index, step); });
}

double DetectionScore::MeanAp50() const {
  return MeanOfDefined(classes(), [&](int c) { return ApAt(c, 0); });
}

double DetectionScore::MeanAp50To95() const {
  return MeanOfDefined(classes(), [&](int c) { return ApOverSteps(c); });
}

DetectionRates DetectionScore::RatesAt(int class_index, double threshold) const {
  DetectionRates rates;
  for (const FoundBox& box : found_[class_index]) {
    if (static_cast<double>(box.confidence) < threshold) continue;
    ++((box.hits & 1u) != 0 ? rates.hits : rates.extras);
  }
  rates.misses = truths_[class_index] - rates.hits;
  return rates;
}

OperatingPoint DetectionScore::At(double threshold) const {
  std::vector<DetectionRates> rates;
  OperatingPoint point;
  point.threshold = threshold;
  for (int c = 0; c < classes(); ++c) {
    rates.push_back(RatesAt(c, threshold));
    point.rates += rates.back();
  }
  point.mean_class_precision =
      MeanOfDefined(classes(), [&](int c) { return rates[c].precision(); });
  point.mean_class_recall = MeanOfDefined(classes(), [&](int c) { return rates[c].recall(); });
  return point;
}

std::optional<OperatingPoint> DetectionScore::AtBestF1() const {
  std::vector<ScoredHit> hits;
  std::int64_t truths = 0;
  for (int c = 0; c < classes(); ++c) {
    truths += truths_[c];
    for (const FoundBox& box : found_[c]) hits.push_back({box.confidence, (box.hits & 1u) != 0});
  }
  const std::vector<CurvePoint> curve = PrecisionRecallCurve(std::move(hits), truths);
  if (curve.empty()) return std::nullopt;
  const auto best = std::max_element(
      curve.begin(), curve.end(),
      [](const CurvePoint& a, const CurvePoint& b) { return a.rates.f1() < b.rates.f1(); });
  return At(static_cast<double>(best->confidence));
}

}  // namespace semantic_slam
