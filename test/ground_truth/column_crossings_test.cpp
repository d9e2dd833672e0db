#include "semantic_slam/ground_truth/column_crossings.h"

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"

namespace semantic_slam {
namespace {

const CellLattice kLattice{0.1, {0.0, 0.0}};

TEST(ColumnCrossingsTest, ABoxIsEnteredFromBelowAndLeftAtItsTop) {
  const auto crossings =
      CrossColumns(BoxMesh({0.15f, 0.05f, 1}, {0.1f, 0.1f, 0.4f}), Rigid3d::Identity(), kLattice);
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_EQ(crossings[0].cell, cv::Point(1, 0));
  EXPECT_FALSE(crossings[0].faces_up);
  EXPECT_NEAR(crossings[0].z_m, 0.8, 1e-6);  // meshes are floats
  EXPECT_TRUE(crossings[1].faces_up);
  EXPECT_NEAR(crossings[1].z_m, 1.2, 1e-6);
}

TEST(ColumnCrossingsTest, ALineThroughASharedEdgeCrossesOneTriangle) {
  // The diagonal of each face runs through the centres of the cells (0, 0), (1, 1), (2, 2).
  const auto crossings =
      CrossColumns(BoxMesh({0.15f, 0.15f, 1}, {0.3f, 0.3f, 0.4f}), Rigid3d::Identity(), kLattice);
  EXPECT_EQ(crossings.size(), 2u * 9u);
  EXPECT_EQ(SolidParts(crossings).size(), 9u);
}

TEST(ColumnCrossingsTest, FollowsThePose) {
  Rigid3d T = Rigid3d::Identity();
  T.translation() << -0.5, 0.2, 3.0;
  const auto crossings = CrossColumns(BoxMesh({0.05f, 0.05f, 1}, {0.1f, 0.1f, 0.4f}), T, kLattice);
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_EQ(crossings[0].cell, cv::Point(-5, 2));
  EXPECT_NEAR(crossings[0].z_m, 3.8, 1e-6);
}

TEST(ColumnCrossingsTest, ASlopeIsCrossedWhereItIs) {
  // From z = 0 at x = 0 to z = 1 at x = 1.
  const auto crossings =
      CrossColumns(QuadMesh({0, 1, 0}, {1, 0, 1}, {0, -1, 0}), Rigid3d::Identity(), kLattice);
  ASSERT_EQ(crossings.size(), 100u);
  for (const Crossing& crossing : crossings) {
    EXPECT_NEAR(crossing.z_m, 0.1 * (crossing.cell.x + 0.5), 1e-6);
    EXPECT_TRUE(crossing.faces_up);
  }
}

TEST(ColumnCrossingsTest, SolidsInsideOfEachOtherAreOne) {
  const Mesh mesh = Merged({BoxMesh({0.05f, 0.05f, 1}, {0.1f, 0.1f, 2}),
                            BoxMesh({0.05f, 0.05f, 1.5f}, {0.1f, 0.1f, 3})});
  const auto parts = SolidParts(CrossColumns(mesh, Rigid3d::Identity(), kLattice));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].low_m, 0.0, 1e-6);
  EXPECT_NEAR(parts[0].high_m, 3.0, 1e-6);
}

TEST(ColumnCrossingsTest, SheetsEncloseNothing) {
  const Mesh floor = FloorMesh(0.1f, 0.1f);  // is left, but was never entered
  EXPECT_TRUE(SolidParts(CrossColumns(floor, Rigid3d::Identity(), kLattice)).empty());
  const Mesh ceiling = QuadMesh({0, 0, 2}, {0.1f, 0, 0}, {0, 0.1f, 0});  // the other way round
  EXPECT_TRUE(SolidParts(CrossColumns(ceiling, Rigid3d::Identity(), kLattice)).empty());
}

TEST(ColumnCrossingsTest, NothingIsCrossedByNothing) {
  EXPECT_TRUE(CrossColumns({}, Rigid3d::Identity(), kLattice).empty());
  EXPECT_TRUE(SolidParts({}).empty());
}

}  // namespace
}  // namespace semantic_slam
