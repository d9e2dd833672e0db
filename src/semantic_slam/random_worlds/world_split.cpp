#include "semantic_slam/random_worlds/world_split.h"

#include <algorithm>
#include <map>
#include <set>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

struct SplitPatterns {
  std::vector<PatternChoice> training;
  std::vector<PatternChoice> validation;
};

// Which split may show which pattern, by what stands there usually. "wall", "floor" and "ceiling"
// are no patterns but the building's surfaces. What is absent has no alternative.
const std::map<std::string, SplitPatterns>& SplitTable() {
  static const std::map<std::string, SplitPatterns> table{
      {"wall",
       {{{"plaster", 7},
         {"wallpaper", 1},
         {"striped_wallpaper", 1},
         {"brick", 0.7},
         {"tiles", 0.6}},
        {{"plaster", 7}, {"hexagon_wallpaper", 1.5}, {"subway_tiles", 0.8}, {"panelling", 0.8}}}},
      {"floor",
       {{{"parquet", 4},
         {"carpet", 2.5},
         {"tiles", 1.5},
         {"checkered_tiles", 0.5},
         {"concrete", 0.5}},
        {{"herringbone", 3}, {"carpet_tiles", 2}, {"terrazzo", 1.5}}}},
      {"ceiling",
       {{{"plaster", 6}, {"ceiling_tiles", 3}},
        {{"plaster", 6}, {"perforated_panels", 2}, {"panelling", 0.7}}}},
      {"wood", {{{"wood", 5}, {"chipboard", 1}}, {{"veneer", 3}, {"rustic_wood", 2}}}},
      {"fabric",
       {{{"fabric", 4}, {"striped_fabric", 1}, {"corduroy", 1}, {"leather", 1.5}},
        {{"tweed", 3}, {"floral_fabric", 1}}}},
      {"curtain",
       {{{"curtain", 2}, {"banded_curtain", 1}}, {{"sheer_curtain", 2}, {"floral_curtain", 1}}}},
      {"painting", {{{"painting", 2}, {"photograph", 1}}, {{"drawing", 1}, {"graphic_print", 1}}}},
  };
  return table;
}

// Consecutive designs of a kind.
struct DesignRange {
  int first = 0;
  int count = 0;
};

// The designs that validation has of kinds of which training was given more afterwards: worlds for
// validation stay as they are, and so do the figures measured on them.
const std::map<std::string, DesignRange>& HeldOutTable() {
  static const std::map<std::string, DesignRange> table{
      {"armchair", {4, 2}},
      {"bed", {3, 1}},
      {"chair", {8, 3}},
      {"coffee_table", {4, 2}},
      {"conference_table", {4, 1}},
      {"desk", {5, 2}},
      {"dresser", {3, 1}},
      {"office_chair", {4, 1}},
      {"round_table", {3, 1}},
      {"sideboard", {3, 1}},
      {"single_bed", {3, 1}},
      {"sofa", {5, 2}},
      {"table", {5, 2}},
      {"wardrobe", {2, 1}},
  };
  return table;
}

// Precondition: the kind has two designs or more.
DesignRange HeldOutOf(const FurnitureKind& kind) {
  const auto found = HeldOutTable().find(kind.name);
  if (found != HeldOutTable().end()) return found->second;
  const int count = std::max(1, DesignCount(kind) / 3);
  return {DesignCount(kind) - count, count};
}

}  // namespace

WorldSplit SplitNamed(const std::string& name) {
  if (name == "training") return WorldSplit::kTraining;
  if (name == "validation") return WorldSplit::kValidation;
  throw ConfigError("a split is training or validation, not '" + name + "'");
}

std::vector<int> DesignsFor(WorldSplit split, const FurnitureKind& kind) {
  const int all = DesignCount(kind);
  if (all == 1) return {0};
  const auto [first, count] = HeldOutOf(kind);
  std::vector<int> designs;
  for (int design = 0; design < all; ++design) {
    const bool is_held_out = design >= first && design < first + count;
    if (is_held_out == (split == WorldSplit::kValidation)) designs.push_back(design);
  }
  return designs;
}

const std::vector<PatternChoice>& PatternsFor(WorldSplit split, const std::string& usual) {
  static const std::vector<PatternChoice> kNoAlternative;
  const auto found = SplitTable().find(usual);
  if (found == SplitTable().end()) return kNoAlternative;
  return split == WorldSplit::kTraining ? found->second.training : found->second.validation;
}

const std::vector<std::string>& TrainingPatterns() {
  static const std::vector<std::string> patterns = [] {
    std::set<std::string> names;
    for (const auto& [usual, choices] : SplitTable()) {
      if (usual == "painting") continue;
      for (const PatternChoice& choice : choices.training) names.insert(choice.pattern);
    }
    return std::vector<std::string>(names.begin(), names.end());
  }();
  return patterns;
}

std::uint64_t SeedFor(WorldSplit split, RandomStream& random) {
  return 2 * (random.Bits() >> 2) + (split == WorldSplit::kTraining ? 0 : 1);
}

double ProportionFor(WorldSplit split, const FurnitureKind& kind, RandomStream& random) {
  const double u = random.Uniform();
  const bool is_training = split == WorldSplit::kTraining;
  if (DesignCount(kind) > 1) return is_training ? 0.75 + 0.5 * u : 0.85 + 0.3 * u;
  return is_training ? 0.82 + 0.18 * u : 1.02 + 0.18 * u;
}

}  // namespace semantic_slam
