#pragma once

#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"

namespace semantic_slam {

// Writes the object map as JSON: for each object its id, class probabilities by name, position and
// covariance, oriented box, heights, hollowness ("no", "partly" or "full") and footprint, in metres
// in the map frame. Throws InputError naming `path` if it cannot be written.
void WriteObjectMap(const std::string& path, const ObjectMap& map,
                    const LabelVocabulary& vocabulary);

// Reads such a file. Throws InputError naming `path` if it cannot be read, is not such a file or
// was made with another label set.
ObjectMap ReadObjectMap(const std::string& path, const LabelVocabulary& vocabulary);

// "no", "partly" or "full".
const char* ToString(Hollowness hollowness);

}  // namespace semantic_slam
