#include "semantic_slam/worlds/building_file.h"

#include <gtest/gtest.h>

#include "testing/mesh_checks.h"
#include "testing/world_text.h"

namespace semantic_slam {
namespace {

class BuildingFileTest : public testing::Test {
 protected:
  World Load(const std::string& openings) {
    return text_.Load(kTwoRooms + ("openings:\n" + openings));
  }
  std::string ErrorOf(const std::string& openings) {
    return text_.ErrorOf(kTwoRooms + ("openings:\n" + openings));
  }

  WorldText text_;
};

TEST_F(BuildingFileTest, EveryRoomHasItsMaterials) {
  const World world = text_.Load(
      "materials:\n"
      "  planks: {pattern: parquet, rgb: [1, 2, 3]}\n"
      "rooms:\n"
      "  - {name: hall, from: [0, 0], to: [4, 3], floor: planks, walls: [4, 5, 6], east_wall: [7, "
      "8, 9]}\n");
  const auto colour = [&](const WorldObject& object, int surface) {
    return world.materials[object.surfaces[surface].material].rgb;
  };
  EXPECT_EQ(colour(WorldText::Named(world, "hall/floor"), 0),
            (std::array<std::uint8_t, 3>{1, 2, 3}));
  const WorldObject& walls = WorldText::Named(world, "hall/wall");
  EXPECT_EQ(colour(walls, 0), (std::array<std::uint8_t, 3>{4, 5, 6}));
  EXPECT_EQ(colour(walls, 2), (std::array<std::uint8_t, 3>{7, 8, 9}));
}

TEST_F(BuildingFileTest, ADoorFillsItsHole) {
  const World world =
      Load("  - {kind: door, name: d, at: [4, 1.5], width_m: 1.0, opens_to: hall, open_deg: 90}\n");
  const WorldObject& door = WorldText::Named(world, "d");
  EXPECT_TRUE(door.T_world_object.translation().isApprox(Eigen::Vector3d(4, 1.5, 0), 1e-9));
  EXPECT_NEAR(door.T_world_object.linear()(0, 0), -1.0, 1e-9);  // its front looks into the hall
  EXPECT_FALSE(door.is_structure);
}

TEST_F(BuildingFileTest, APassageHasAFrameButNoLeaf) {
  const World framed = Load("  - {kind: passage, at: [4, 1.5], width_m: 1.2}\n");
  const WorldObject& frame = WorldText::Named(framed, "door_1");
  for (const Surface& surface : frame.surfaces) {
    for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
      EXPECT_TRUE(std::abs(p.y()) > 0.5f || p.z() > 2.0f) << p.transpose();
    }
  }
  const World bare = Load("  - {kind: passage, at: [4, 1.5], width_m: 1.2, frame: false}\n");
  EXPECT_EQ(bare.objects.size(), 6u);  // floor, ceiling and walls of two rooms
}

TEST_F(BuildingFileTest, AWindowLooksIntoItsRoom) {
  const World world = Load("  - {kind: window, name: w, at: [2, 0], width_m: 1.5, sill_m: 1}\n");
  const WorldObject& window = WorldText::Named(world, "w");
  EXPECT_NEAR(window.T_world_object.translation().z(), 1.0, 1e-9);
  EXPECT_LT(window.T_world_object.translation().y(), 0.0);  // towards the outside of the wall
  EXPECT_NEAR(window.T_world_object.linear()(1, 0), 1.0, 1e-9);
}

TEST_F(BuildingFileTest, WhatFillsAHoleInAnOuterWallEndsNearItsOuterFace) {
  const World world = Load(
      "  - {kind: window, name: w, at: [2, 0]}\n"
      "  - {kind: door, name: d, at: [0, 1.5]}\n");
  const double outer_m = 0.05 - 0.22;  // from the inner face
  Eigen::AlignedBox3d window;
  Eigen::AlignedBox3d door;
  const auto extend = [](Eigen::AlignedBox3d& box, const WorldObject& object) {
    for (const Surface& surface : object.surfaces) {
      for (const Eigen::Vector3f& p : surface.mesh.positions_m) {
        box.extend(object.T_world_object * p.cast<double>());
      }
    }
  };
  extend(window, WorldText::Named(world, "w"));
  extend(door, WorldText::Named(world, "d"));
  EXPECT_NEAR(window.min().y(), outer_m + 0.02, 1e-6);
  EXPECT_NEAR(door.min().x(), outer_m - 0.015, 1e-6);  // its casing is before the wall
  EXPECT_NEAR(door.max().x(), 0.05 + 0.015, 1e-6);
}

TEST_F(BuildingFileTest, RefusesByFileLineAndKey) {
  EXPECT_EQ(ErrorOf("  - {kind: hatch, at: [4, 1]}\n"),
            "w.yaml:6: openings/0/kind = hatch, but must be door, passage or window");
  EXPECT_EQ(ErrorOf("  - {kind: door, at: [3, 1]}\n"),
            "w.yaml:6: openings/0: opening at [3, 1] is in no wall");
  EXPECT_EQ(ErrorOf("  - {kind: door, at: [4, 1], opens_to: attic}\n"),
            "w.yaml:6: openings/0/opens_to = attic, but must be a room whose wall it is in");
  EXPECT_EQ(ErrorOf("  - {kind: door, at: [4, 1], hinge: top}\n"),
            "w.yaml:6: openings/0/hinge = top, but must be left or right");
  EXPECT_EQ(ErrorOf("  - {kind: door, at: [4, 1], open_deg: 200}\n"),
            "w.yaml:6: openings/0: door's open_deg = 200, but must be in [0, 95]");
  ExpectOneLineWith(ErrorOf("  - {kind: window, at: [4, 1], hinge: left}\n"),
                    {"w.yaml:6: unknown key openings/0/hinge, expected one of: "});
  EXPECT_EQ(text_.ErrorOf("rooms:\n  - {name: a, from: [0, 0], to: [0.3, 4]}\n"),
            "w.yaml:2: rooms/0: room a must be at least 0.5 m wide inside");
  EXPECT_EQ(text_.ErrorOf("rooms:\n  - {name: a, from: [0, 0]}\n"),
            "w.yaml: missing key rooms/0/to");
  EXPECT_EQ(text_.ErrorOf("rooms:\n  - {name: a, from: [0, 0], to: [1, .nan]}\n"),
            "w.yaml:2: rooms/0/to = [1, .nan], but must be [x, y] within 1 km");
}

}  // namespace
}  // namespace semantic_slam
