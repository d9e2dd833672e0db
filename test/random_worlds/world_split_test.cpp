#include "semantic_slam/random_worlds/world_split.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/worlds/pattern.h"

namespace semantic_slam {
namespace {

constexpr WorldSplit kBoth[] = {WorldSplit::kTraining, WorldSplit::kValidation};

std::vector<std::string> UsualPatterns() {
  std::vector<std::string> usual{"wall", "floor", "ceiling"};
  for (const auto& [name, pattern] : Patterns()) usual.push_back(name);
  return usual;
}

TEST(WorldSplit, IsReadByName) {
  EXPECT_EQ(SplitNamed("training"), WorldSplit::kTraining);
  EXPECT_EQ(SplitNamed("validation"), WorldSplit::kValidation);
  EXPECT_THROW(SplitNamed("test"), ConfigError);
}

TEST(WorldSplit, SharesNoDesignOfSeveral) {
  for (const FurnitureKind& kind : FurnitureKinds()) {
    std::vector<int> all = DesignsFor(WorldSplit::kTraining, kind);
    const std::vector<int> validation = DesignsFor(WorldSplit::kValidation, kind);
    ASSERT_FALSE(all.empty());
    ASSERT_FALSE(validation.empty());
    if (DesignCount(kind) == 1) continue;
    all.insert(all.end(), validation.begin(), validation.end());
    EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), all.size()) << kind.name;
    EXPECT_EQ(static_cast<int>(all.size()), DesignCount(kind)) << kind.name;
  }
}

TEST(WorldSplit, HoldsOutTheLastThirdWhereTrainingGotNoMoreDesigns) {
  const FurnitureKind& stand = FindFurnitureKind("night_stand");
  ASSERT_EQ(DesignCount(stand), 3);
  EXPECT_EQ(DesignsFor(WorldSplit::kTraining, stand), (std::vector<int>{0, 1}));
  EXPECT_EQ(DesignsFor(WorldSplit::kValidation, stand), std::vector<int>{2});
}

// Worlds for validation must stay as they are, or figures measured on them cannot be compared.
TEST(WorldSplit, KeepsTheDesignsOfValidationWhereTrainingGotMore) {
  const std::map<std::string, std::vector<int>> held_out{
      {"armchair", {4, 5}}, {"bed", {3}},        {"chair", {8, 9, 10}}, {"coffee_table", {4, 5}},
      {"desk", {5, 6}},     {"sofa", {5, 6}},    {"table", {5, 6}},     {"conference_table", {4}},
      {"round_table", {3}}, {"single_bed", {3}}, {"office_chair", {4}}, {"dresser", {3}},
      {"sideboard", {3}},   {"wardrobe", {2}}};
  for (const auto& [name, designs] : held_out) {
    const FurnitureKind& kind = FindFurnitureKind(name);
    EXPECT_EQ(DesignsFor(WorldSplit::kValidation, kind), designs) << name;
    const std::vector<int> training = DesignsFor(WorldSplit::kTraining, kind);
    EXPECT_TRUE(std::is_sorted(training.begin(), training.end())) << name;
    EXPECT_EQ(training.back(), DesignCount(kind) - 1) << name;
  }
}

TEST(WorldSplit, NamesPatternsThatExist) {
  for (const std::string& usual : UsualPatterns()) {
    for (const WorldSplit split : kBoth) {
      for (const PatternChoice& choice : PatternsFor(split, usual)) {
        EXPECT_EQ(Patterns().count(choice.pattern), 1u) << choice.pattern;
      }
    }
  }
}

TEST(WorldSplit, SharesOfTheAlternativesPlasterAlone) {
  for (const std::string& usual : UsualPatterns()) {
    std::set<std::string> training;
    for (const PatternChoice& choice : PatternsFor(WorldSplit::kTraining, usual)) {
      training.insert(choice.pattern);
    }
    for (const PatternChoice& choice : PatternsFor(WorldSplit::kValidation, usual)) {
      if (choice.pattern == "plaster") continue;
      EXPECT_EQ(training.count(choice.pattern), 0u) << choice.pattern << " for " << usual;
    }
  }
}

TEST(WorldSplit, SharesNoSeed) {
  RandomStream random(1);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(SeedFor(WorldSplit::kTraining, random) % 2, 0u);
    EXPECT_EQ(SeedFor(WorldSplit::kValidation, random) % 2, 1u);
  }
}

TEST(WorldSplit, GivesKindsOfOneDesignOtherProportions) {
  RandomStream random(1);
  const auto& kinds = FurnitureKinds();
  const auto single = std::find_if(
      kinds.begin(), kinds.end(), [](const FurnitureKind& kind) { return DesignCount(kind) == 1; });
  ASSERT_NE(single, kinds.end());
  for (int i = 0; i < 100; ++i) {
    EXPECT_LE(ProportionFor(WorldSplit::kTraining, *single, random), 1.0);
    EXPECT_GT(ProportionFor(WorldSplit::kValidation, *single, random), 1.0);
  }
}

TEST(WorldSplit, VariesProportionsMoreInTraining) {
  const FurnitureKind& chair = FindFurnitureKind("chair");
  for (const auto& [split, most] :
       {std::pair(WorldSplit::kTraining, 0.25), std::pair(WorldSplit::kValidation, 0.15)}) {
    RandomStream random(1);
    double widest = 0.0;
    for (int i = 0; i < 200; ++i) {
      widest = std::max(widest, std::abs(ProportionFor(split, chair, random) - 1.0));
    }
    EXPECT_LE(widest, most);
    EXPECT_GT(widest, 0.9 * most);
  }
}

}  // namespace
}  // namespace semantic_slam
