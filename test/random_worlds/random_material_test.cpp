#include "semantic_slam/random_worlds/random_material.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr int kDraws = 2000;

// How often each pattern comes in place of `usual`.
std::map<std::string, int> PatternsInPlaceOf(WorldSplit split, const std::string& usual) {
  RandomStream random(1);
  std::map<std::string, int> count;
  for (int i = 0; i < kDraws; ++i) {
    ++count[RandomMaterial(split, MakeMaterial(usual, {120, 90, 60}), random).pattern];
  }
  return count;
}

std::set<std::string> ChoicesFor(WorldSplit split, const std::string& usual) {
  std::set<std::string> names;
  for (const PatternChoice& choice : PatternsFor(split, usual)) names.insert(choice.pattern);
  return names;
}

int CountOthers(const std::map<std::string, int>& count, const std::set<std::string>& expected) {
  int others = 0;
  for (const auto& [pattern, times] : count) others += expected.count(pattern) == 0 ? times : 0;
  return others;
}

TEST(RandomMaterialTest, InTrainingPatternsNowAndThenBelongElsewhere) {
  const auto count = PatternsInPlaceOf(WorldSplit::kTraining, "fabric");
  const int others = CountOthers(count, ChoicesFor(WorldSplit::kTraining, "fabric"));
  EXPECT_GT(others, kDraws / 10);
  EXPECT_LT(others, kDraws / 4);
  EXPECT_GT(count.count("brick"), 0u) << "a sofa of bricks";
}

TEST(RandomMaterialTest, InValidationNever) {
  for (const std::string usual : {"fabric", "wood", "curtain"}) {
    EXPECT_EQ(CountOthers(PatternsInPlaceOf(WorldSplit::kValidation, usual),
                          ChoicesFor(WorldSplit::kValidation, usual)),
              0);
  }
}

TEST(RandomMaterialTest, NoPatternIsOneOfValidationsOrAPicture) {
  const std::set<std::string> training(TrainingPatterns().begin(), TrainingPatterns().end());
  EXPECT_EQ(training.count("photograph"), 0u);
  for (const std::string usual : {"wall", "floor", "ceiling", "wood", "fabric", "curtain"}) {
    for (const std::string& pattern : ChoicesFor(WorldSplit::kValidation, usual)) {
      if (pattern == "plaster") continue;
      EXPECT_EQ(training.count(pattern), 0u) << pattern;
    }
  }
}

TEST(RandomMaterialTest, WhatHasNoAlternativesStays) {
  for (const WorldSplit split : {WorldSplit::kTraining, WorldSplit::kValidation}) {
    EXPECT_EQ(PatternsInPlaceOf(split, "screen"), (std::map<std::string, int>{{"screen", kDraws}}));
  }
}

TEST(RandomMaterialTest, PicturesShowPictures) {
  const auto count = PatternsInPlaceOf(WorldSplit::kTraining, "painting");
  EXPECT_EQ(CountOthers(count, ChoicesFor(WorldSplit::kTraining, "painting")), 0);
}

}  // namespace
}  // namespace semantic_slam
