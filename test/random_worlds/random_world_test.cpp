// Random worlds are rooms: nothing floats or is in something else; the two splits share nothing
// that a network could know by heart.

#include "semantic_slam/random_worlds/random_world.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "testing/world_checks.h"

namespace semantic_slam {
namespace {

constexpr int kWorlds = 4;  // of each split

const LabelVocabulary& Vocabulary() {
  static const LabelVocabulary vocabulary =
      LabelVocabulary::Load(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/labels.yaml");
  return vocabulary;
}

class RandomWorlds : public testing::TestWithParam<WorldSplit> {
 protected:
  World Make(std::uint64_t seed) const { return MakeRandomWorld(GetParam(), seed, Vocabulary()); }
};

TEST_P(RandomWorlds, AreTheSameForTheSameSeed) {
  const World a = Make(3), b = Make(3);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  EXPECT_EQ(a.materials, b.materials);
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    EXPECT_EQ(a.objects[i].name, b.objects[i].name);
    EXPECT_EQ(a.objects[i].T_world_object.matrix(), b.objects[i].T_world_object.matrix());
  }
}

TEST_P(RandomWorlds, DifferByTheSeed) {
  EXPECT_NE(Make(3).materials, Make(4).materials);
}

TEST_P(RandomWorlds, AreLit) {
  for (int seed = 0; seed < kWorlds; ++seed) EXPECT_FALSE(Make(seed).lights.empty());
}

TEST_P(RandomWorlds, HaveFurniture) {
  for (int seed = 0; seed < kWorlds; ++seed) {
    EXPECT_GT(Make(seed).objects.size(), 10u) << seed;
  }
}

// Cushions give way by 3 cm, and chairs are pushed below tables, among whose legs a foot may be.
TEST_P(RandomWorlds, NothingIsInSomethingElse) {
  constexpr double kDepthM = 0.05;
  int pairs = 0;
  int overlapping = 0;
  for (int seed = 0; seed < kWorlds; ++seed) {
    const World world = Make(seed);
    const std::vector<Solid> solids = StillSolids(world);
    for (const Solid& a : solids) {
      for (const Solid& b : solids) {
        if (&a == &b || (a.object().is_structure && b.object().is_structure)) continue;
        ++pairs;
        const auto where = DeepInside(a, b, kDepthM);
        if (!where) continue;
        ++overlapping;
        ADD_FAILURE() << seed << ": " << a.object().name << " reaches into " << b.object().name
                      << " at " << where->transpose();
      }
    }
  }
  EXPECT_EQ(overlapping, 0) << "of " << pairs;
}

TEST_P(RandomWorlds, NothingFloats) {
  for (int seed = 0; seed < kWorlds; ++seed) {
    const World world = Make(seed);
    const std::vector<Solid> solids = StillSolids(world);
    for (const Solid& solid : solids) {
      if (solid.object().is_structure) continue;
      EXPECT_TRUE(IsHeld(solid, solids)) << seed << ": " << solid.object().name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Splits, RandomWorlds,
                         testing::Values(WorldSplit::kTraining, WorldSplit::kValidation),
                         [](const auto& split) {
                           return split.param == WorldSplit::kTraining ? "Training" : "Validation";
                         });

using Look = std::pair<std::string, std::uint64_t>;  // pattern, seed

std::set<Look> LooksOf(WorldSplit split) {
  std::set<Look> looks;
  for (int seed = 0; seed < 4 * kWorlds; ++seed) {
    for (const Material& material : MakeRandomWorld(split, seed, Vocabulary()).materials) {
      looks.insert({material.pattern, material.seed});
    }
  }
  return looks;
}

TEST(RandomWorldSplits, ShareNoTexture) {
  const std::set<Look> training = LooksOf(WorldSplit::kTraining);
  const std::set<Look> validation = LooksOf(WorldSplit::kValidation);
  std::vector<Look> common;
  std::set_intersection(training.begin(), training.end(), validation.begin(), validation.end(),
                        std::back_inserter(common));
  EXPECT_TRUE(common.empty()) << common.size() << ", such as " << common.front().first;
}

}  // namespace
}  // namespace semantic_slam
