#pragma once

#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model.h"

namespace semantic_slam {

// The vocabulary's label of each of the network's classes, in the order of its scores: the one that
// the card maps the class's name to, else the one of the same name, else unknown. Throws
// ConfigError naming the card if it maps from a name that is none of the network's classes, or to
// one that is not in the vocabulary.
std::vector<LabelId> MapClassesToLabels(const Model& model, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
