// The worlds in config/worlds are rooms: everything stands on something and nothing is in the way
// of anything else.

#include <string>

#include <gtest/gtest.h>

#include "semantic_slam/worlds/world_file.h"
#include "testing/world_checks.h"

namespace semantic_slam {
namespace {

const LabelVocabulary& Vocabulary() {
  static const LabelVocabulary vocabulary =
      LabelVocabulary::Load(std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/labels.yaml");
  return vocabulary;
}

class ConfigWorlds : public testing::TestWithParam<const char*> {
 protected:
  ConfigWorlds()
      : world_(LoadWorld(
            std::string(SEMANTIC_SLAM_SOURCE_DIR) + "/config/worlds/" + GetParam() + ".yaml",
            Vocabulary())),
        solids_(StillSolids(world_)) {}

  bool Has(const std::string& label) const {
    const LabelId id = Vocabulary().Find(label).value();
    return std::any_of(world_.objects.begin(), world_.objects.end(),
                       [&](const WorldObject& object) { return object.label == id; });
  }

  const World world_;
  const std::vector<Solid> solids_;
};

TEST_P(ConfigWorlds, NothingFloats) {
  for (const Solid& solid : solids_) {
    if (solid.object().is_structure) continue;
    EXPECT_TRUE(IsHeld(solid, solids_)) << solid.object().name;
  }
}

TEST_P(ConfigWorlds, NothingIsInSomethingElse) {
  // Cushions give way by 3 cm, and so much may furniture reach into the casing of a door.
  constexpr double kDepthM = 0.03;
  for (const Solid& a : solids_) {
    for (const Solid& b : solids_) {
      if (&a == &b || (a.object().is_structure && b.object().is_structure)) continue;
      const auto where = DeepInside(a, b, kDepthM);
      EXPECT_FALSE(where) << a.object().name << " reaches into " << b.object().name << " at "
                          << where.value_or(Eigen::Vector3d::Zero()).transpose();
    }
  }
}

TEST_P(ConfigWorlds, IsBetweenFloorAndCeiling) {
  const Eigen::AlignedBox3d& bounds = world_.bounds_m;
  EXPECT_NEAR(bounds.min().z(), -0.1, 1e-6);
  EXPECT_NEAR(bounds.max().z(), 2.7, 1e-6);
  for (const Solid& solid : solids_) {
    if (solid.object().is_structure) continue;
    EXPECT_GT(solid.bounds().min().z(), -0.001) << solid.object().name;
    EXPECT_LT(solid.bounds().max().z(), 2.601) << solid.object().name;
  }
}

TEST_P(ConfigWorlds, EveryRoomHasALamp) {
  for (const Solid& floor : solids_) {
    if (floor.object().label != Vocabulary().Find("floor")) continue;
    EXPECT_TRUE(std::any_of(world_.lights.begin(), world_.lights.end(), [&](const Light& light) {
      Eigen::Vector3d below = light.centre_m;
      below.z() = -0.05;
      return floor.bounds().contains(below);
    })) << floor.object().name;
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, ConfigWorlds, testing::Values("home", "office"),
                         [](const auto& world) { return std::string(world.param); });

class Home : public ConfigWorlds {};

TEST_P(Home, HasWhatAHomeHas) {
  for (const char* label :
       {"bed",          "pillow",    "night_stand", "dresser", "cabinet", "sofa",  "tv",
        "coffee_table", "bookshelf", "table",       "chair",   "counter", "sink",  "oven",
        "fridge",       "microwave", "curtain",     "picture", "mirror",  "plant", "lamp",
        "floor_mat",    "door",      "window",      "clock",   "books",   "cup"}) {
    EXPECT_TRUE(Has(label)) << label;
  }
}

INSTANTIATE_TEST_SUITE_P(Worlds, Home, testing::Values("home"));

class Office : public ConfigWorlds {};

TEST_P(Office, HasWhatAnOfficeHas) {
  for (const char* label : {"desk", "chair", "coffee_table", "conference_table", "sofa",
                            "whiteboard", "person", "laptop", "keyboard", "mouse", "telephone",
                            "blinds", "cabinet", "shelves", "bag", "box", "paper", "bench"}) {
    EXPECT_TRUE(Has(label)) << label;
  }
}

TEST_P(Office, SomebodyWalksAndSomebodyStands) {
  int walking = 0;
  int standing = 0;
  for (const WorldObject& object : world_.objects) {
    if (object.label != Vocabulary().Find("person")) continue;
    ++(object.IsMoving() ? walking : standing);
  }
  EXPECT_EQ(walking, 1);
  EXPECT_EQ(standing, 1);
}

INSTANTIATE_TEST_SUITE_P(Worlds, Office, testing::Values("office"));

}  // namespace
}  // namespace semantic_slam
