#include "semantic_slam/network_evaluation/confusion_matrix.h"

#include <cassert>

namespace semantic_slam {

ConfusionMatrix::ConfusionMatrix(std::size_t classes)
    : classes_(static_cast<int>(classes)), counts_((classes + 1) * (classes + 1), 0) {}

void ConfusionMatrix::Add(const ConfusionMatrix& other) {
  assert(other.classes_ == classes_);
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
}

std::int64_t ConfusionMatrix::TruthCount(int truth) const {
  std::int64_t sum = 0;
  for (int predicted = 0; predicted <= none(); ++predicted) sum += count(truth, predicted);
  return sum;
}

std::int64_t ConfusionMatrix::PredictedCount(int predicted) const {
  std::int64_t sum = 0;
  for (int truth = 0; truth <= none(); ++truth) sum += count(truth, predicted);
  return sum;
}

}  // namespace semantic_slam
