#include "semantic_slam/common/label_check.h"

#include <string>

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

}  // namespace semantic_slam
