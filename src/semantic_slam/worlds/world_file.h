#pragma once

#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// Builds the world that a YAML file describes (docs/simulation.md): rooms with doors and windows,
// furniture by kind, place, size and material, lamps, people. Throws ConfigError naming file, line
// and key for anything that cannot be built.
World LoadWorld(const std::string& path, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
