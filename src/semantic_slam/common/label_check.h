#pragma once

#include <cstdint>

#include "semantic_slam/common/label_vocabulary.h"

// What every message and file that carries label ids is asked. `who` begins the line of the
// InputError: "detections", say.

namespace semantic_slam {

// Throws InputError if `hash` is not the vocabulary's.
void CheckLabelSet(const char* who, std::uint64_t hash, const LabelVocabulary& vocabulary);

// Throws InputError if no class of the vocabulary has that id.
void CheckLabel(const char* who, LabelId label, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
