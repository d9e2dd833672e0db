#pragma once

#include <cstdint>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/random_worlds/world_split.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// A furnished building of one to four rooms as there are many: homes, offices, now and then with
// things where they do not belong, so that a network learns what things look like and not where
// they stand. The same split and seed give the same world; the two splits share no design of
// furniture that has more than one, no figured pattern and no seed. Throws ConfigError if the
// vocabulary lacks a label.
World MakeRandomWorld(WorldSplit split, std::uint64_t seed, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
