#include "semantic_slam/worlds/wall_panel.h"

#include <gtest/gtest.h>

#include "testing/mesh_checks.h"

namespace semantic_slam {
namespace {

void ExpectSolid(const Mesh& mesh, double volume_m3) {
  EXPECT_EQ(FaultOf(mesh), "");
  EXPECT_EQ(OpenEdgeOf(mesh), "");
  EXPECT_NEAR(VolumeOf(mesh), volume_m3, 1e-5);  // single precision
}

TEST(WallPanelTest, WithoutHolesIsABox) {
  const Mesh wall = WallPanelMesh(4, 2.5f, 0.1f, {});
  ExpectSolid(wall, 4 * 2.5 * 0.1);
  EXPECT_TRUE(BoundsOf(wall).min().isApprox(Eigen::Vector3f(-0.1f, 0, 0)));
  EXPECT_TRUE(BoundsOf(wall).max().isApprox(Eigen::Vector3f(0, 4, 2.5f)));
  EXPECT_EQ(wall.triangles.size(), 12u);
}

TEST(WallPanelTest, ADoorAndAWindowAreCutOut) {
  const Mesh wall = WallPanelMesh(4, 2.5f, 0.1f, {{0.5f, 1.5f, 0, 2}, {2, 3, 1, 2}});
  ExpectSolid(wall, (4 * 2.5 - 2 - 1) * 0.1);
}

TEST(WallPanelTest, AHoleMayReachTheCeilingOrTheCorner) {
  ExpectSolid(WallPanelMesh(4, 2.5f, 0.1f, {{1, 3, 0, 2.5f}}), 2 * 2.5 * 0.1);
  ExpectSolid(WallPanelMesh(4, 2.5f, 0.1f, {{0, 1, 0, 2}}), (10 - 2) * 0.1);
}

TEST(WallPanelTest, TheTextureRunsOnAroundHoles) {
  const Mesh wall = WallPanelMesh(4, 2.5f, 0.1f, {{2, 3, 1, 2}});
  for (std::size_t i = 0; i < wall.positions_m.size(); ++i) {
    if (wall.normals[i].x() < 0.5f) continue;  // the front
    EXPECT_NEAR(wall.texture_m[i].x(), wall.positions_m[i].y(), 1e-6f);
    EXPECT_NEAR(wall.texture_m[i].y(), 2.5f - wall.positions_m[i].z(), 1e-6f);
  }
}

}  // namespace
}  // namespace semantic_slam
