#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace semantic_slam {

// Counts how often what is truly of one class (row) is predicted as another (column). Beside the
// classes, row and column none() stand for what is of no class: background, or labels that do not
// count. Not thread-safe.
class ConfusionMatrix {
 public:
  explicit ConfusionMatrix(std::size_t classes);

  int classes() const { return classes_; }
  int none() const { return classes_; }

  // Precondition: 0 <= truth, predicted <= none().
  void Add(int truth, int predicted, std::int64_t count = 1) {
    counts_[Index(truth, predicted)] += count;
  }
  void Add(const ConfusionMatrix& other);  // Precondition: as many classes

  std::int64_t count(int truth, int predicted) const { return counts_[Index(truth, predicted)]; }
  std::int64_t TruthCount(int truth) const;          // sum of a row
  std::int64_t PredictedCount(int predicted) const;  // sum of a column

 private:
  std::size_t Index(int truth, int predicted) const {
    return static_cast<std::size_t>(truth) * (classes_ + 1) + predicted;
  }

  const int classes_;
  std::vector<std::int64_t> counts_;  // row by row
};

}  // namespace semantic_slam
