#pragma once

#include <array>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"

namespace semantic_slam {

// Which classes of a vocabulary look alike, so that a network may take one for the other: a table
// for a desk. By the names in config/labels.yaml; a class by another name is like no other.
// Immutable, so safe from any thread.
class SimilarLabels {
 public:
  explicit SimilarLabels(const LabelVocabulary& vocabulary);

  // By ascending id, without the label itself; may be empty.
  const std::vector<LabelId>& Of(LabelId label) const { return similar_[label]; }

 private:
  std::array<std::vector<LabelId>, 256> similar_;
};

}  // namespace semantic_slam
