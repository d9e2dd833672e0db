#pragma once

#include <cstdint>
#include <vector>

namespace semantic_slam {

// A found box: how sure the detector is, and whether it is a true one.
struct ScoredHit {
  float confidence = 0.0f;
  bool is_hit = false;
};

// Counts of true positives, false positives and false negatives, thesis eq. (4.8). Each rate is NaN
// where there was nothing to count.
struct DetectionRates {
  std::int64_t hits = 0;    // TP
  std::int64_t extras = 0;  // FP
  std::int64_t misses = 0;  // FN

  double precision() const;
  double recall() const;
  double f1() const;  // 2 TP / (2 TP + FP + FN)

  DetectionRates& operator+=(const DetectionRates& other);
};

// What holds if boxes down to a confidence count.
struct CurvePoint {
  float confidence = 0.0f;
  DetectionRates rates;
};

// One point per confidence that occurs, the highest first: boxes of equal confidence count
// together, so the order of images does not matter. `truths` is the number of true boxes.
std::vector<CurvePoint> PrecisionRecallCurve(std::vector<ScoredHit> found, std::int64_t truths);

// Of each point the highest precision at its recall or a greater one.
std::vector<double> PrecisionEnvelope(const std::vector<CurvePoint>& curve);

// Area below the envelope, "all-point interpolation" (PASCAL VOC 2010), the AP of thesis eq. (4.7).
// NaN without true boxes, 0 if there are some and nothing is found.
double AveragePrecision(const std::vector<CurvePoint>& curve, std::int64_t truths);

}  // namespace semantic_slam
