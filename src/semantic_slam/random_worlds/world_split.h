#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/worlds/furniture.h"

namespace semantic_slam {

// What random worlds are for. Networks are judged by things that they were not trained on.
enum class WorldSplit { kTraining, kValidation };

// Throws ConfigError unless `name` is training or validation.
WorldSplit SplitNamed(const std::string& name);

// The designs of a kind that worlds of a split use, ascending. Of two designs or more, validation
// has the last third, at least one, or, where training was given more afterwards, those that it had
// before; training has the others. One design alone serves both.
std::vector<int> DesignsFor(WorldSplit split, const FurnitureKind& kind);

// A stuff that surfaces may be of, and how often.
struct PatternChoice {
  std::string pattern;
  double weight = 1.0;
};

// The patterns that may replace a kind's usual one: "wood" stands for all woods. Patterns that show
// figures belong to one split; those without (plain plaster, plastic) and those without
// alternatives to both, with other seeds.
const std::vector<PatternChoice>& PatternsFor(WorldSplit split, const std::string& usual);

// All patterns of training that cover surfaces, none of them pictures.
const std::vector<std::string>& TrainingPatterns();

// A seed of materials and pieces that no world of the other split uses.
std::uint64_t SeedFor(WorldSplit split, RandomStream& random);

// A factor for depth and width against the usual ones; in training further from it. Kinds with one
// design get other proportions in each split: training makes them narrower for their height,
// validation wider.
double ProportionFor(WorldSplit split, const FurnitureKind& kind, RandomStream& random);

}  // namespace semantic_slam
