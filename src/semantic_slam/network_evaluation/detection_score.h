#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "semantic_slam/network_evaluation/average_precision.h"
#include "semantic_slam/network_evaluation/box_matching.h"

namespace semantic_slam {

constexpr double kMatchIou = 0.5;  // from which on a box counts as found, thesis Table 4.1
constexpr int kIouSteps = 10;      // of mAP@0.5:0.95: 0.5, 0.55, ... 0.95

// How well the boxes of one class were found.
struct ClassDetectionScore {
  std::int64_t truths = 0;
  double ap50 = 0.0;     // NaN without true boxes
  double ap50_95 = 0.0;  // mean over the steps of IoU; NaN likewise
  DetectionRates rates;  // at IoU 0.5 and the detector's threshold
};

// All classes together at one threshold.
struct OperatingPoint {
  double threshold = 0.0;
  DetectionRates rates;               // sums over all classes, thesis eq. (4.8)
  double mean_class_precision = 0.0;  // over the classes for which it is defined; NaN without any
  double mean_class_recall = 0.0;
};

// Collects found and true boxes image by image. Keeps 8 bytes per found box. Not thread-safe.
class DetectionScore {
 public:
  // `threshold` is the confidence from which on the detector is believed.
  DetectionScore(std::size_t classes, double threshold);

  // Adds an image; `found` by descending confidence. Returns the image's rates at the threshold.
  DetectionRates Add(const std::vector<ClassBox>& truth, const std::vector<ClassBox>& found);

  int classes() const { return static_cast<int>(found_.size()); }
  double threshold() const { return threshold_; }
  std::int64_t truths(int class_index) const { return truths_[class_index]; }

  ClassDetectionScore OfClass(int class_index) const;
  // At IoU 0.5.
  std::vector<CurvePoint> Curve(int class_index) const;

  // Thesis eq. (4.7): means over the classes with true boxes, NaN without any.
  double MeanAp50() const;
  double MeanAp50To95() const;

  OperatingPoint At(double threshold) const;
  // Where F1 of all classes together is highest, of equal ones at the highest threshold. nullopt if
  // nothing was found.
  std::optional<OperatingPoint> AtBestF1() const;

 private:
  struct FoundBox {
    float confidence = 0.0f;
    std::uint16_t hits = 0;  // bit i: it is a true one at IoU 0.5 + 0.05 i
  };

  std::vector<FoundBox> Match(const std::vector<ClassBox>& truth,
                              const std::vector<ClassBox>& found, int class_index) const;
  std::vector<CurvePoint> CurveAt(int class_index, int iou_step) const;
  double ApAt(int class_index, int iou_step) const;
  double ApOverSteps(int class_index) const;
  DetectionRates RatesAt(int class_index, double threshold) const;

  const double threshold_;
  std::vector<std::vector<FoundBox>> found_;  // by class
  std::vector<std::int64_t> truths_;          // by class
};

}  // namespace semantic_slam
