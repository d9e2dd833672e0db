#include "semantic_slam/worlds/mesh.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "testing/mesh_checks.h"

namespace semantic_slam {
namespace {

constexpr double kPi = 3.14159265358979;

void ExpectSolid(const Mesh& mesh) {
  EXPECT_EQ(FaultOf(mesh), "");
  EXPECT_EQ(OpenEdgeOf(mesh), "");
}

TEST(MeshTest, BoxIsClosedAndAsLargeAsAsked) {
  const Mesh box = BoxMesh({1, 2, 3}, {0.4f, 0.6f, 0.8f});
  ExpectSolid(box);
  EXPECT_NEAR(VolumeOf(box), 0.4 * 0.6 * 0.8, 1e-6);  // single precision
  EXPECT_TRUE(BoundsOf(box).min().isApprox(Eigen::Vector3f(0.8f, 1.7f, 2.6f)));
  EXPECT_TRUE(BoundsOf(box).max().isApprox(Eigen::Vector3f(1.2f, 2.3f, 3.4f)));
}

TEST(MeshTest, TextureOfABoxRunsRightAndDownAsSeenFromOutside) {
  const Mesh box = BoxMesh(Eigen::Vector3f::Zero(), {0.4f, 0.6f, 0.8f});
  for (std::size_t i = 0; i < box.positions_m.size(); ++i) {
    if (box.normals[i].x() < 0.5f) continue;  // the face that looks to +x: right is +y
    EXPECT_FLOAT_EQ(box.texture_m[i].x(), box.positions_m[i].y() + 0.3f);
    EXPECT_FLOAT_EQ(box.texture_m[i].y(), 0.4f - box.positions_m[i].z());
  }
}

TEST(MeshTest, QuadFacesWhoSeesItsTextureUpright) {
  const Mesh quad = QuadMesh({0, 0, 1}, {0, 2, 0}, {0, 0, -1});
  EXPECT_EQ(FaultOf(quad), "");
  EXPECT_TRUE(quad.normals[0].isApprox(Eigen::Vector3f::UnitX()));
  EXPECT_TRUE(quad.texture_m[0].isZero());
  EXPECT_TRUE(quad.texture_m[2].isApprox(Eigen::Vector2f(2, 1)));
}

TEST(MeshTest, CylinderIsClosed) {
  const Mesh cylinder = CylinderMesh({0, 0, 1}, 0.5f, 0.5f, 2.0f, 64);
  ExpectSolid(cylinder);
  EXPECT_NEAR(VolumeOf(cylinder), kPi * 0.25 * 2.0, 0.005);  // 64 sides are 0.16 % short
  EXPECT_FLOAT_EQ(BoundsOf(cylinder).min().z(), 1.0f);
  EXPECT_FLOAT_EQ(BoundsOf(cylinder).max().z(), 3.0f);
}

TEST(MeshTest, FrustumAndConesAreClosed) {
  ExpectSolid(CylinderMesh({0, 0, 0}, 0.3f, 0.1f, 0.5f));
  ExpectSolid(CylinderMesh({0, 0, 0}, 0.3f, 0.0f, 0.5f));
  ExpectSolid(CylinderMesh({0, 0, 0}, 0.0f, 0.3f, 0.5f));
  EXPECT_NEAR(VolumeOf(CylinderMesh({0, 0, 0}, 0.3f, 0.0f, 0.5f, 64)), kPi * 0.09 * 0.5 / 3, 1e-4);
}

TEST(MeshTest, EllipsoidIsClosedWithSmoothNormals) {
  const Mesh ellipsoid = EllipsoidMesh({1, 0, 0}, {0.3f, 0.2f, 0.1f}, 64);
  ExpectSolid(ellipsoid);
  EXPECT_NEAR(VolumeOf(ellipsoid), 4.0 / 3.0 * kPi * 0.006, 0.0002);  // 64 sides: 0.4 % short
  EXPECT_NEAR(BoundsOf(ellipsoid).max().x(), 1.3f, 1e-6f);
  EXPECT_NEAR(BoundsOf(ellipsoid).min().z(), -0.1f, 1e-6f);
}

TEST(MeshTest, AppendMovesPositionsAndTurnsNormals) {
  Rigid3d T = Rigid3d::Identity();
  T.linear() = Eigen::AngleAxisd(kPi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(10, 0, 0);
  Mesh mesh = BoxMesh(Eigen::Vector3f::Zero(), {1, 1, 1});
  Append(mesh, BoxMesh({2, 0, 0}, {1, 1, 1}), T);
  ExpectSolid(mesh);
  EXPECT_NEAR(VolumeOf(mesh), 2.0, 1e-5);
  EXPECT_TRUE(BoundsOf(mesh).max().isApprox(Eigen::Vector3f(10.5f, 2.5f, 0.5f)));
  ASSERT_EQ(mesh.normals.size(), 48u);
  EXPECT_TRUE(mesh.normals[24].isApprox(Eigen::Vector3f::UnitY()));  // was +x
}

}  // namespace
}  // namespace semantic_slam
