#include "semantic_slam/worlds/placement_file.h"

#include <gtest/gtest.h>

#include "testing/world_text.h"

namespace semantic_slam {
namespace {

class PlacementFileTest : public testing::Test {
 protected:
  // The pose of the last piece.
  Rigid3d PoseOf(const std::string& furniture) {
    return text_.Load(kTwoRooms + ("furniture:\n" + furniture)).objects.back().T_world_object;
  }
  std::string ErrorOf(const std::string& furniture) {
    return text_.ErrorOf(kTwoRooms + ("furniture:\n" + furniture));
  }
  static void ExpectAt(const Rigid3d& T, double x, double y, double z, double yaw_deg) {
    EXPECT_LT((T.translation() - Eigen::Vector3d(x, y, z)).norm(), 1e-6)
        << T.translation().transpose();
    const Eigen::AngleAxisd yaw(yaw_deg * M_PI / 180, Eigen::Vector3d::UnitZ());
    EXPECT_TRUE(T.linear().isApprox(yaw.toRotationMatrix(), 1e-6));
  }

  WorldText text_;
};

TEST_F(PlacementFileTest, OnThePlan) {
  ExpectAt(PoseOf("  - {kind: stool, at: [1, 2], yaw_deg: 30, z_m: 0.1}\n"), 1, 2, 0.1, 30);
  ExpectAt(PoseOf("  - {kind: stool, at: [1, 2]}\n"), 1, 2, 0, 0);
}

TEST_F(PlacementFileTest, WithItsBackToAWall) {
  const std::string size = "size_m: [0.5, 1, 2]";
  ExpectAt(PoseOf("  - {kind: wardrobe, wall: hall/west, along_m: 1, " + size + "}\n"),
           0.05 + 0.02 + 0.25, 1, 0, 0);
  ExpectAt(PoseOf("  - {kind: wardrobe, wall: hall/north, along_m: 2, gap_m: 0.1, " + size + "}\n"),
           2, 3 - 0.05 - 0.1 - 0.25, 0, -90);
}

TEST_F(PlacementFileTest, HangingOnAWall) {
  ExpectAt(PoseOf("  - {kind: poster, wall: bath/south, along_m: 5, z_m: 1.2}\n"), 5, 0.05, 1.2,
           90);
}

TEST_F(PlacementFileTest, OnSomething) {
  const std::string table = "  - {kind: table, name: t, at: [2, 1], yaw_deg: 90}\n";
  ExpectAt(PoseOf(table + "  - {kind: cup, on: t, at: [0.1, 0.2], yaw_deg: 10}\n"), 1.8, 1.1, 0.75,
           100);
  ExpectAt(PoseOf(table + "  - {kind: cup, on: t}\n"), 2, 1, 0.75, 90);
  ExpectAt(PoseOf(table + "  - {kind: cup, on: t, z_m: 0.7}\n"), 2, 1, 0.7, 90);
}

TEST_F(PlacementFileTest, BesideSomething) {
  ExpectAt(PoseOf("  - {kind: desk, name: d, at: [2, 1], yaw_deg: 180}\n"
                  "  - {kind: chair, beside: d, at: [0.5, 0], yaw_deg: 180}\n"),
           1.5, 1, 0, 0);
}

TEST_F(PlacementFileTest, UnderTheCeiling) {
  ExpectAt(PoseOf("  - {kind: ceiling_lamp, at: [2, 1], size_m: [0.4, 0.4, 0.1]}\n"), 2, 1, 2.5, 0);
}

TEST_F(PlacementFileTest, RefusesByFileLineAndKey) {
  EXPECT_EQ(ErrorOf("  - {kind: stool}\n"), "w.yaml: missing key furniture/0/at");
  EXPECT_EQ(ErrorOf("  - {kind: stool, at: [1]}\n"),
            "w.yaml:6: furniture/0/at = [1], but must be [x, y] within 1 km");
  EXPECT_EQ(ErrorOf("  - {kind: stool, at: [1, 1], yaw_deg: .inf}\n"),
            "w.yaml:6: furniture/0/yaw_deg = .inf, but must be a number within 1000");
  EXPECT_EQ(
      ErrorOf("  - {kind: cup, on: t}\n"),
      "w.yaml:6: furniture/0/on = t, but must be the name of a thing that the file has before");
  EXPECT_EQ(ErrorOf("  - {kind: table, name: t, at: [1, 1]}\n  - {kind: cup, on: t, at: [3, 0]}\n"),
            "w.yaml:7: furniture/1/on = t, but must be something that has a surface at this place");
  EXPECT_EQ(ErrorOf("  - {kind: stool, wall: west, along_m: 1}\n"),
            "w.yaml:6: furniture/0/wall = west, but must be a room and a side: kitchen/north");
  EXPECT_EQ(ErrorOf("  - {kind: stool, wall: attic/west, along_m: 1}\n"),
            "w.yaml:6: furniture/0: room attic is unknown, expected one of: hall, bath");
  EXPECT_EQ(ErrorOf("  - {kind: stool, wall: hall/up, along_m: 1}\n"),
            "w.yaml:6: furniture/0: a wall is west, south, east or north, not up");
  EXPECT_EQ(ErrorOf("  - {kind: stool, wall: hall/west, along_m: 9}\n"),
            "w.yaml:6: furniture/0: the place along the wall of room hall = 9, but must be in "
            "[0.05, 2.95]");
  EXPECT_EQ(ErrorOf("  - {kind: ceiling_lamp, at: [9, 1]}\n"),
            "w.yaml:6: furniture/0: hangs from a ceiling, so it must be in a room");
}

}  // namespace
}  // namespace semantic_slam
