#include "semantic_slam/worlds/world_file.h"

#include <gtest/gtest.h>

#include "testing/world_text.h"

namespace semantic_slam {
namespace {

TEST(WorldFileTest, AnEmptyWorldIsOne) {
  const World world = WorldText().Load("{}");
  EXPECT_EQ(world.name, "w");
  EXPECT_TRUE(world.objects.empty());
  EXPECT_TRUE(world.bounds_m.isEmpty());
}

TEST(WorldFileTest, ReadsLights) {
  const World world = WorldText().Load(
      "ambient_rgb: [0.1, 0.2, 0.3]\n"
      "lights:\n"
      "  - {centre_m: [1, 2, 3], side_m: 0.4, radiant_rgb: [1, 0.9, 0.8]}\n"
      "  - {centre_m: [0, 0, 2]}\n");
  EXPECT_EQ(world.ambient_rgb, (std::array<float, 3>{0.1f, 0.2f, 0.3f}));
  ASSERT_EQ(world.lights.size(), 2u);
  EXPECT_EQ(world.lights[0].centre_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(world.lights[0].side_m, 0.4);
  EXPECT_EQ(world.lights[0].radiant_rgb[2], 0.8f);
}

TEST(WorldFileTest, TheSameFileGivesTheSameWorld) {
  const std::string yaml = std::string(kTwoRooms) +
                           "furniture:\n"
                           "  - {kind: bookshelf, at: [1, 1]}\n"
                           "  - {kind: plant, at: [2, 2]}\n";
  const World a = WorldText().Load(yaml);
  const World b = WorldText().Load(yaml);
  ASSERT_EQ(a.objects.size(), b.objects.size());
  EXPECT_TRUE(a.materials == b.materials);
  for (std::size_t i = 0; i < a.objects.size(); ++i) {
    for (std::size_t j = 0; j < a.objects[i].surfaces.size(); ++j) {
      EXPECT_EQ(a.objects[i].surfaces[j].mesh.positions_m,
                b.objects[i].surfaces[j].mesh.positions_m);
    }
  }
}

TEST(WorldFileTest, RefusesByFileLineAndKey) {
  const WorldText text;
  EXPECT_EQ(text.ErrorOf("houses: []\n"),
            "w.yaml:1: unknown key houses, expected one of: ambient_rgb, furniture, groups, "
            "lights, materials, openings, rooms, wall_thickness_m");
  EXPECT_EQ(text.ErrorOf("lights:\n  - {centre_m: [1, 2]}\n"),
            "w.yaml:2: lights/0/centre_m = [1, 2], but must be [x, y, z]");
  EXPECT_EQ(text.ErrorOf("lights:\n  - {centre_m: [1, 2, 3], side_m: -1}\n"),
            "w.yaml:2: lights/0/side_m = -1, but must be positive");
  EXPECT_EQ(text.ErrorOf("ambient_rgb: [1, 1, -1]\n"),
            "w.yaml:1: ambient_rgb = [1, 1, -1], but must be numbers in [0, 100]");
  EXPECT_EQ(text.ErrorOf("lights: 3\n"), "w.yaml:1: lights = 3, but must be a list");
  EXPECT_NE(text.ErrorOf("rooms: [\n"), "");
}

}  // namespace
}  // namespace semantic_slam
