#pragma once

#include <string>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/random_worlds/world_split.h"
#include "semantic_slam/worlds/material.h"

namespace semantic_slam {

// A material in place of what is usual there: another pattern of the same sort, a colour that such
// stuff has (now and then any), another seed and gloss; as bright. In training the pattern is now
// and then one that belongs elsewhere, so that networks learn to look at shapes.
Material RandomMaterial(WorldSplit split, const Material& usual, RandomStream& random);

// The same for a building's surface: "wall", "floor" or "ceiling".
Material RandomSurface(WorldSplit split, const std::string& surface, RandomStream& random);

}  // namespace semantic_slam
