#pragma once

#include <string>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model.h"

namespace semantic_slam {

// The labels that the network's classes map to, by ascending id; unknown is none of them. Throws
// ConfigError as MapClassesToLabels() does, or if no class has a label.
ClassList ClassesOfModel(const Model& model, const LabelVocabulary& vocabulary);

// The vocabulary's label of a class name in somebody's data set: the one that the card maps the
// name to, else the one of that name, also if only capitals, blanks or hyphens differ ("Coffee
// table" is coffee_table), else unknown.
LabelId LabelOfName(const std::string& name, const ModelCard& card,
                    const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
