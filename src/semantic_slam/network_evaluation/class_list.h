#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model.h"

namespace semantic_slam {

constexpr int kIgnoredClass = -1;

// The classes that a network is judged by, as training/ counts them.
struct ClassList {
  std::vector<std::string> names;
  std::vector<LabelId> labels;  // the label that each class is named after
  std::array<int, 256>
      of_label;  // by label id: index of the class that it counts as, or kIgnoredClass

  std::size_t size() const { return names.size(); }
};

// Reads `classes: [names]` and, optionally, `merge: {label: class}` for labels that count as
// another class; all other labels are ignored. Throws ConfigError naming the file if a name is no
// label of the vocabulary or appears twice, if there are none, or if a label is merged into what is
// no class.
ClassList ReadClassList(const std::string& path, const LabelVocabulary& vocabulary);

// The labels that the network's classes map to, by ascending id; unknown is none of them. Throws
// ConfigError as MapClassesToLabels() does, or if no class has a label.
ClassList ClassesOfModel(const Model& model, const LabelVocabulary& vocabulary);

// The vocabulary's label of a class name in somebody's data set: the one that the card maps the
// name to, else the one of that name, also if only capitals, blanks or hyphens differ ("Coffee
// table" is coffee_table), else unknown.
LabelId LabelOfName(const std::string& name, const ModelCard& card,
                    const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
