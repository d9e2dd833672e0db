#include "semantic_slam/object_mapping/label_evidence.h"

#include <algorithm>
#include <cmath>

namespace semantic_slam {
namespace {

constexpr double kLeastConfidence = 0.05;
constexpr double kMostConfidence = 0.95;
constexpr double kMaxProbability = 0.99;

}  // namespace

void LabelEvidence::Add(LabelId label, float confidence) {
  const double p = std::clamp<double>(confidence, kLeastConfidence, kMostConfidence);
  AddLogOdds(label, std::log(p * (classes_ - 1) / (1.0 - p)));
  Limit();
}

void LabelEvidence::Add(const LabelEvidence& other) {
  for (const Weight& weight : other.weights_) AddLogOdds(weight.label, weight.log_odds);
  Limit();
}

void LabelEvidence::AddLogOdds(LabelId label, double log_odds) {
  const auto at =
      std::lower_bound(weights_.begin(), weights_.end(), label,
                       [](const Weight& weight, LabelId id) { return weight.label < id; });
  if (at != weights_.end() && at->label == label) {
    at->log_odds += log_odds;
  } else {
    weights_.insert(at, {label, log_odds});
  }
}

// Takes the same from all, so that their ratios stay, but none goes below a class never seen.
void LabelEvidence::Limit() {
  double most = 0.0;
  for (const Weight& weight : weights_) most = std::max(most, weight.log_odds);
  const double limit = std::log(kMaxProbability / (1.0 - kMaxProbability) * (classes_ - 1));
  const double excess = std::max(0.0, most - limit);
  for (Weight& weight : weights_) weight.log_odds = std::max(0.0, weight.log_odds - excess);
}

LabelId LabelEvidence::Best() const {
  const auto best =
      std::max_element(weights_.begin(), weights_.end(),
                       [](const Weight& a, const Weight& b) { return a.log_odds < b.log_odds; });
  return best->label;
}

std::vector<LabelProbability> LabelEvidence::Probabilities() const {
  double sum = std::max(0, classes_ - static_cast<int>(weights_.size()));
  for (const Weight& weight : weights_) sum += std::exp(weight.log_odds);
  std::vector<LabelProbability> probabilities;
  for (const Weight& weight : weights_) {
    probabilities.push_back({weight.label, static_cast<float>(std::exp(weight.log_odds) / sum)});
  }
  std::stable_sort(probabilities.begin(), probabilities.end(),
                   [](const LabelProbability& a, const LabelProbability& b) {
                     return a.probability > b.probability;
                   });
  return probabilities;
}

}  // namespace semantic_slam
