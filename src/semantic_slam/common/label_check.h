#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"

// What everything that speaks of labels is asked. `who` begins the line of the error: "detections",
// say, or an option's name.

namespace semantic_slam {

// Throws InputError if `hash` is not the vocabulary's.
void CheckLabelSet(const char* who, std::uint64_t hash, const LabelVocabulary& vocabulary);

// Throws InputError if no class of the vocabulary has that id.
void CheckLabel(const char* who, LabelId label, const LabelVocabulary& vocabulary);

// The classes of a list of names with commas between them, as options have it. Throws ConfigError
// if there is no class of a name.
std::vector<LabelId> FindLabels(const char* who, const std::string& names,
                                const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
