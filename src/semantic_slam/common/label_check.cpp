#include "semantic_slam/common/label_check.h"

#include <sstream>

#include "semantic_slam/common/error.h"

namespace semantic_slam {

void CheckLabelSet(const char* who, std::uint64_t hash, const LabelVocabulary& vocabulary) {
  if (hash == vocabulary.hash()) return;
  throw InputError(std::string(who) + ": made with another label set, hash " +
                   std::to_string(hash) + ", expected " + std::to_string(vocabulary.hash()));
}

void CheckLabel(const char* who, LabelId label, const LabelVocabulary& vocabulary) {
  if (vocabulary.Contains(label)) return;
  throw InputError(std::string(who) + ": label id " + std::to_string(label) +
                   " is not in the vocabulary");
}

std::vector<LabelId> FindLabels(const char* who, const std::string& names,
                                const LabelVocabulary& vocabulary) {
  std::vector<LabelId> labels;
  std::istringstream list(names);
  for (std::string name; std::getline(list, name, ',');) {
    const auto begin = name.find_first_not_of(' ');
    if (begin == std::string::npos) continue;
    name = name.substr(begin, name.find_last_not_of(' ') - begin + 1);
    const auto label = vocabulary.Find(name);
    if (!label) throw ConfigError(std::string(who) + ": '" + name + "' is not in the vocabulary");
    labels.push_back(*label);
  }
  return labels;
}

}  // namespace semantic_slam
