#include "semantic_slam/network_evaluation/average_precision.h"

#include <algorithm>
#include <limits>

#include "semantic_slam/network_evaluation/share.h"

namespace semantic_slam {

double DetectionRates::precision() const {
  return ShareOf(hits, hits + extras);
}

double DetectionRates::recall() const {
  return ShareOf(hits, hits + misses);
}

double DetectionRates::f1() const {
  return ShareOf(2 * hits, 2 * hits + extras + misses);
}

DetectionRates& DetectionRates::operator+=(const DetectionRates& other) {
  hits += other.hits;
  extras += other.extras;
  misses += other.misses;
  return *this;
}

std::vector<CurvePoint> PrecisionRecallCurve(std::vector<ScoredHit> found, std::int64_t truths) {
  std::sort(found.begin(), found.end(),
            [](const ScoredHit& a, const ScoredHit& b) { return a.confidence > b.confidence; });
  std::vector<CurvePoint> curve;
  DetectionRates rates{0, 0, truths};
  for (const ScoredHit& box : found) {
    rates.hits += box.is_hit ? 1 : 0;
    rates.extras += box.is_hit ? 0 : 1;
    rates.misses = truths - rates.hits;
    if (!curve.empty() && curve.back().confidence == box.confidence) {
      curve.back().rates = rates;
    } else {
      curve.push_back({box.confidence, rates});
    }
  }
  return curve;
}

std::vector<double> PrecisionEnvelope(const std::vector<CurvePoint>& curve) {
  std::vector<double> envelope(curve.size());
  double highest = 0.0;
  for (std::size_t i = curve.size(); i-- > 0;) {
    highest = std::max(highest, curve[i].rates.precision());
    envelope[i] = highest;
  }
  return envelope;
}

double AveragePrecision(const std::vector<CurvePoint>& curve, std::int64_t truths) {
  if (truths == 0) return std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> envelope = PrecisionEnvelope(curve);
  double area = 0.0;
  double recall = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    area += (curve[i].rates.recall() - recall) * envelope[i];
    recall = curve[i].rates.recall();
  }
  return area;
}

}  // namespace semantic_slam
