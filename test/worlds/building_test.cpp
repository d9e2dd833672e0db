#include "semantic_slam/worlds/building.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"
#include "testing/mesh_checks.h"

namespace semantic_slam {
namespace {

Room RoomOf(const std::string& name, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  Room room;
  room.name = name;
  room.area_m.extend(from_m);
  room.area_m.extend(to_m);
  return room;
}

// A hall of 4 x 3 m and, to its east, a bath of 2 x 3 m.
Building TwoRooms() {
  Building building(0.1);
  building.AddRoom(RoomOf("hall", {0, 0}, {4, 3}));
  building.AddRoom(RoomOf("bath", {4, 0}, {6, 3}));
  return building;
}

WallOpening DoorAt(const Eigen::Vector2d& at_m, double width_m = 0.9) {
  WallOpening door;
  door.at_m = at_m;
  door.width_m = width_m;
  return door;
}

Mesh WholeMesh(const Furniture& furniture) {
  Mesh whole;
  for (const FurniturePart& part : furniture.parts) Append(whole, part.mesh);
  return whole;
}

Eigen::AlignedBox3f BoundsOf(const Furniture& furniture) {
  return BoundsOf(WholeMesh(furniture));
}

TEST(BuildingTest, ARoomHasFloorCeilingAndWalls) {
  const Building building = TwoRooms();
  const std::vector<Furniture> parts = building.BuildRoom(building.rooms()[0]);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].label, "floor");
  EXPECT_NEAR(BoundsOf(parts[0]).max().z(), 0.0f, 1e-6f);
  EXPECT_EQ(parts[1].label, "ceiling");
  EXPECT_NEAR(BoundsOf(parts[1]).min().z(), 2.6f, 1e-6f);
  EXPECT_EQ(parts[2].label, "wall");
  EXPECT_NEAR(BoundsOf(parts[2]).max().z(), 2.6f, 1e-6f);
  for (const Furniture& part : parts) {
    EXPECT_EQ(FaultOf(WholeMesh(part)), "");
    EXPECT_EQ(OpenEdgeOf(WholeMesh(part)), "");
    EXPECT_GT(VolumeOf(WholeMesh(part)), 0.0);
  }
}

TEST(BuildingTest, WallsMeetInTheMiddleAndAreThickOutside) {
  const Building building = TwoRooms();
  const Eigen::AlignedBox3f hall = BoundsOf(building.BuildRoom(building.FindRoom("hall"))[2]);
  const Eigen::AlignedBox3f bath = BoundsOf(building.BuildRoom(building.FindRoom("bath"))[2]);
  EXPECT_NEAR(hall.max().x(), 4.0f, 1e-5f);
  EXPECT_NEAR(bath.min().x(), 4.0f, 1e-5f);
  EXPECT_LT(hall.min().x(), -0.1f);
  EXPECT_GT(bath.max().x(), 6.1f);
  EXPECT_EQ(building.HalfThickness(building.FindRoom("hall"), Side::kEast), 0.05);
  EXPECT_GT(building.HalfThickness(building.FindRoom("hall"), Side::kWest), 0.2);
}

TEST(BuildingTest, TheInsideIsFree) {
  const Building building = TwoRooms();
  const Mesh walls = WholeMesh(building.BuildRoom(building.FindRoom("hall"))[2]);
  const Eigen::AlignedBox2f inside(Eigen::Vector2f(0.07f, 0.07f), Eigen::Vector2f(3.93f, 2.93f));
  for (const Eigen::Vector3f& p : walls.positions_m) {
    EXPECT_FALSE(inside.contains(p.head<2>())) << p.transpose();
  }
}

TEST(BuildingTest, EachWallHasItsMaterial) {
  Building building(0.1);
  Room room = RoomOf("hall", {0, 0}, {4, 3});
  for (int i = 0; i < 4; ++i) room.walls[i].seed = 10 + i;
  building.AddRoom(room);
  const Furniture walls = building.BuildRoom(room)[2];
  const auto centre_of = [&](std::uint64_t seed) {
    for (const FurniturePart& part : walls.parts) {
      if (part.material.seed == seed) return Eigen::Vector3f(BoundsOf(part.mesh).center());
    }
    return Eigen::Vector3f(0, 0, 0);
  };
  EXPECT_LT(centre_of(10).x(), 0.1f);
  EXPECT_LT(centre_of(11).y(), 0.1f);
  EXPECT_GT(centre_of(12).x(), 3.9f);
  EXPECT_GT(centre_of(13).y(), 2.9f);
}

TEST(BuildingTest, AnOpeningGoesThroughBothRoomsWalls) {
  Building building = TwoRooms();
  const double closed = VolumeOf(WholeMesh(building.BuildRoom(building.FindRoom("bath"))[2]));
  building.AddOpening(DoorAt({4, 1.5}));
  EXPECT_EQ(building.SitesOf(DoorAt({4, 1.5})).size(), 2u);
  const double open = VolumeOf(WholeMesh(building.BuildRoom(building.FindRoom("bath"))[2]));
  // Half the wall, and the skirting board, 12 mm thick and 7 cm high.
  EXPECT_NEAR(closed - open, 0.9 * 2.05 * 0.05 + 0.9 * 0.07 * 0.012, 1e-4);
}

TEST(BuildingTest, WallPosesLookIntoTheRoom) {
  const Building building = TwoRooms();
  const Room& hall = building.FindRoom("hall");
  const Eigen::Vector3d centre(2, 1.5, 0);
  for (const Side side : kSides) {
    const Rigid3d T = building.WallPose(
        hall, side, side == Side::kWest || side == Side::kEast ? centre.y() : centre.x());
    const Eigen::Vector3d ahead = T.inverse() * centre;
    EXPECT_NEAR(ahead.y(), 0.0, 1e-9);
    EXPECT_NEAR(ahead.x(), side == Side::kWest || side == Side::kEast ? 1.95 : 1.45, 1e-9);
  }
  ExpectOneLineWith(MessageOf<ConfigError>([&] { building.WallPose(hall, Side::kNorth, 5.0); }),
                    {"the place along the wall of room hall = 5"});
}

TEST(BuildingTest, OpeningPosesLookIntoTheirRoom) {
  Building building = TwoRooms();
  WallOpening window = DoorAt({4, 1});
  window.bottom_m = 0.9;
  const std::vector<WallSite> sites = building.SitesOf(window);
  ASSERT_EQ(sites.size(), 2u);
  for (const WallSite& site : sites) {
    const Rigid3d T = building.OpeningPose(window, site);
    EXPECT_TRUE(T.translation().isApprox(Eigen::Vector3d(4, 1, 0.9), 1e-9));
    EXPECT_NEAR(T.linear()(0, 0), site.room->name == "hall" ? -1.0 : 1.0, 1e-9);
  }
}

TEST(BuildingTest, KnowsInWhichRoomAPlaceIs) {
  const Building building = TwoRooms();
  EXPECT_EQ(building.RoomAt({1, 1})->name, "hall");
  EXPECT_EQ(building.RoomAt({5, 1})->name, "bath");
  EXPECT_EQ(building.RoomAt({5, 4}), nullptr);
}

TEST(BuildingTest, RefusesByName) {
  EXPECT_EQ(MessageOf<ConfigError>([] { Building(0.9); }),
            "wall thickness = 0.9, but must be in [0.02, 0.5]");
  Building building = TwoRooms();
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              building.AddRoom(RoomOf("hall", {9, 9}, {12, 12}));
            }),
            "two rooms are called hall");
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              building.AddRoom(RoomOf("attic", {5, 1}, {8, 4}));
            }),
            "room attic overlaps room bath");
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              building.AddRoom(RoomOf("shaft", {9, 0}, {9.5, 3}));
            }),
            "room shaft must be at least 0.5 m wide inside");
  EXPECT_EQ(MessageOf<ConfigError>([&] {
              building.AddOpening(DoorAt({2, 1}));
            }),
            "opening at [2, 1] is in no wall");
  EXPECT_EQ(MessageOf<ConfigError>([&] { building.FindRoom("cellar"); }),
            "room cellar is unknown, expected one of: hall, bath");
  EXPECT_EQ(MessageOf<ConfigError>([] { SideNamed("top"); }),
            "a wall is west, south, east or north, not top");
}

TEST(BuildingTest, RefusesOpeningsThatDoNotFit) {
  const auto error_of = [](const WallOpening& opening) {
    Building building = TwoRooms();
    building.AddOpening(DoorAt({1, 0}));
    return MessageOf<ConfigError>([&] { building.AddOpening(opening); });
  };
  EXPECT_EQ(error_of(DoorAt({4, 0.3})), "opening at [4, 0.3] reaches beyond the wall of room hall");
  EXPECT_EQ(error_of(DoorAt({1.5, 0})), "opening at [1.5, 0] overlaps another");
  WallOpening tall = DoorAt({3, 3});
  tall.top_m = 2.7;
  EXPECT_EQ(error_of(tall), "opening at [3, 3] reaches beyond the wall of room hall");
  EXPECT_EQ(error_of(DoorAt({2, 3})), "");
}

}  // namespace
}  // namespace semantic_slam
