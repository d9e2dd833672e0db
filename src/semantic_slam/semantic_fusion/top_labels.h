#pragma once

#include <array>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {

// The heaviest of all labels that it is offered, heaviest first; of equally heavy ones those of
// smaller id. A label that weighs nothing is none.
template <typename Weight>
class TopLabels {
 public:
  void Offer(LabelId label, Weight weight) {
    if (!IsHeavier(label, weight, kTopLabels - 1)) return;
    int place = kTopLabels - 1;
    for (; place > 0 && IsHeavier(label, weight, place - 1); --place) {
      labels_[place] = labels_[place - 1];
      weights_[place] = weights_[place - 1];
    }
    labels_[place] = label;
    weights_[place] = weight;
  }

  const std::array<LabelId, kTopLabels>& labels() const { return labels_; }
  const std::array<Weight, kTopLabels>& weights() const { return weights_; }

 private:
  bool IsHeavier(LabelId label, Weight weight, int place) const {
    return weight > weights_[place] || (weight == weights_[place] && label < labels_[place]);
  }

  std::array<LabelId, kTopLabels> labels_{};
  std::array<Weight, kTopLabels> weights_{};
};

}  // namespace semantic_slam
