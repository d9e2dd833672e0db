#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <string>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"

namespace semantic_slam {

constexpr int kIgnoredClass = -1;

// The classes that a network or a map is judged by, as training/ counts them.
struct ClassList {
  std::vector<std::string> names;
  std::vector<LabelId> labels;  // the label that each class is named after
  std::array<int, 256>
      of_label;  // by label id: index of the class that it counts as, or kIgnoredClass
  std::bitset<256> is_optional;      // by label id, of those: such objects may be found or not
  double least_visible_share = 0.0;  // objects of which less is visible may be found or not

  ClassList();  // of no classes: all labels are ignored

  std::size_t size() const { return names.size(); }

  // Another class, named after `label`.
  void Add(const std::string& name, LabelId label);
};

// Reads `classes: [names]` and what else there may be: `merge: {label: class}` for labels that
// count as another class, `optional: [labels]` for objects that could as well be of one of the
// classes, `least_visible_share: 0 to 1`; all other labels are ignored. Throws ConfigError naming
// the file if a name is no label of the vocabulary or appears twice, if there are none, if a label
// is merged into what is no class, or if an optional one is a class.
ClassList ReadClassList(const std::string& path, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
