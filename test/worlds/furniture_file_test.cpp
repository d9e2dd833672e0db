#include "semantic_slam/worlds/furniture_file.h"

#include <gtest/gtest.h>

#include "testing/mesh_checks.h"
#include "testing/world_text.h"

namespace semantic_slam {
namespace {

Eigen::AlignedBox3f BoundsOf(const WorldObject& object) {
  Eigen::AlignedBox3f bounds;
  for (const Surface& surface : object.surfaces) bounds.extend(BoundsOf(surface.mesh));
  return bounds;
}

TEST(FurnitureFileTest, ReadsKindSizeNumbersAndMaterials) {
  const World world = WorldText().Load(
      "furniture:\n"
      "  - {kind: desk, name: d, at: [1, 1], size_m: [0.8, 1.2, 0.7], numbers: {drawers: 1},\n"
      "     materials: {top: [1, 2, 3]}}\n"
      "  - {kind: desk, at: [3, 1]}\n");
  const WorldObject& desk = WorldText::Named(world, "d");
  EXPECT_TRUE(BoundsOf(desk).sizes().isApprox(Eigen::Vector3f(0.8f, 1.2f, 0.7f), 1e-5f));
  EXPECT_GT(desk.surfaces.size(), WorldText::Named(world, "desk_1").surfaces.size());  // handles
  bool coloured = false;
  for (const Surface& surface : desk.surfaces) {
    const auto& rgb = world.materials[surface.material].rgb;
    coloured = coloured || rgb == std::array<std::uint8_t, 3>{1, 2, 3};
  }
  EXPECT_TRUE(coloured);
}

TEST(FurnitureFileTest, OtherNamesAreOtherPieces) {
  const auto books_of = [](const std::string& more) {
    const World world =
        WorldText().Load("furniture:\n  - {kind: bookshelf, at: [1, 1]" + more + "}\n");
    return world.objects[0].surfaces.back().mesh.positions_m;
  };
  EXPECT_EQ(books_of(", name: a"), books_of(", name: a"));
  EXPECT_NE(books_of(", name: a"), books_of(", name: b"));
  EXPECT_EQ(books_of(", name: a, seed: 5"), books_of(", name: b, seed: 5"));
}

TEST(FurnitureFileTest, AGroupIsPlacedAsOne) {
  const World world = WorldText().Load(
      "groups:\n"
      "  workplace:\n"
      "    - {kind: desk, name: desk, at: [0, 0]}\n"
      "    - {kind: cup, on: desk, at: [0.1, 0.2]}\n"
      "    - {kind: stool, at: [1, 0], yaw_deg: 180}\n"
      "furniture:\n"
      "  - {group: workplace, name: a, at: [1, 1]}\n"
      "  - {group: workplace, name: b, at: [5, 1], yaw_deg: 90}\n");
  ASSERT_EQ(world.objects.size(), 6u);
  const Rigid3d& cup = WorldText::Named(world, "b/cup_1").T_world_object;
  EXPECT_LT((cup.translation() - Eigen::Vector3d(4.8, 1.1, 0.74)).norm(), 1e-6);
  const Rigid3d& stool = WorldText::Named(world, "a/stool_1").T_world_object;
  EXPECT_LT((stool.translation() - Eigen::Vector3d(2, 1, 0)).norm(), 1e-9);
}

TEST(FurnitureFileTest, WhoWalksSwingsTheLegs) {
  const World world = WorldText().Load(
      "furniture:\n"
      "  - {kind: person, name: p, walk: {corners: [[0, 0], [4, 0]], speed_mps: 1}}\n"
      "  - {kind: person, name: q, at: [2, 2]}\n");
  const WorldObject& walking = WorldText::Named(world, "p");
  EXPECT_TRUE(walking.IsMoving());
  EXPECT_NEAR(walking.Pose(2.0).translation().x(), 2.0, 1e-9);
  int swinging = 0;
  for (const Surface& surface : walking.surfaces) swinging += surface.swing.has_value();
  EXPECT_GT(swinging, 0);
  for (const Surface& surface : WorldText::Named(world, "q").surfaces) EXPECT_FALSE(surface.swing);
}

TEST(FurnitureFileTest, RefusesByFileLineAndKey) {
  const auto error_of = [](const std::string& furniture) {
    return WorldText().ErrorOf("furniture:\n" + furniture);
  };
  ExpectOneLineWith(error_of("  - {kind: throne, at: [1, 1]}\n"),
                    {"w.yaml:2: furniture/0: furniture kind throne is unknown, expected one of: "});
  ExpectOneLineWith(error_of("  - {kind: stool, at: [1, 1], colour: red}\n"),
                    {"w.yaml:2: unknown key furniture/0/colour"});
  ExpectOneLineWith(error_of("  - {kind: desk, at: [1, 1], numbers: {doors: 1}}\n"),
                    {"w.yaml:2: unknown key furniture/0/numbers/doors, expected one of: design, drawers"});
  EXPECT_EQ(error_of("  - {kind: desk, at: [1, 1], numbers: {drawers: 2}}\n"),
            "w.yaml:2: furniture/0: desk's drawers = 2, but must be in [0, 1]");
  ExpectOneLineWith(error_of("  - {kind: desk, at: [1, 1], materials: {handle: [1, 2, 3]}}\n"),
                    {"w.yaml:2: unknown key furniture/0/materials/handle"});
  ExpectOneLineWith(error_of("  - {kind: desk, at: [1, 1], size_m: [9, 1, 1]}\n"),
                    {"w.yaml:2: furniture/0: desk's depth = 9, but must be in [0.15, 3.75]"});
  EXPECT_EQ(error_of("  - {kind: desk, at: [1, 1], size_m: [9, 1]}\n"),
            "w.yaml:2: furniture/0/size_m = [9, 1], but must be [depth, width, height]");
  EXPECT_EQ(
      error_of("  - {kind: desk, name: d, at: [1, 1]}\n  - {kind: desk, name: d, at: [3, 1]}\n"),
      "w.yaml:3: furniture/1: two things are called d");
  EXPECT_EQ(error_of("  - {kind: person, walk: {corners: [[0, 0]], speed_mps: 1}}\n"),
            "w.yaml:2: furniture/0: a walk needs at least two corners");
  EXPECT_EQ(error_of("  - {group: kitchen, name: k, at: [1, 1]}\n"),
            "w.yaml:2: furniture/0/group = kitchen, but must be one of those under groups");
  EXPECT_EQ(error_of("  - 7\n"), "w.yaml:2: furniture/0 must be a mapping");
}

}  // namespace
}  // namespace semantic_slam
