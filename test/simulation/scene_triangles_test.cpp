#include "semantic_slam/simulation/scene_triangles.h"

#include <gtest/gtest.h>

#include "semantic_slam/simulation/mesh_parts.h"

namespace semantic_slam {
namespace {

// A square metre at x = 2 m, facing the origin, and what it is of.
SceneTriangles Screen(const Rigid3d& T_world_part) {
  WorldObject object;
  object.instance = 3;
  object.label = 4;
  SceneTriangles scene;
  scene.AddSurface(object, {{}, 7, {}});
  scene.AddPart(QuadMesh({2.0f, 0.5f, 0.5f}, {0, -1.0f, 0}, {0, 0, -1.0f}), T_world_part, 9,
                kNoGrid);
  return scene;
}

TEST(SceneTrianglesTest, TrianglesKnowTheirPlaneAndWhatTheyAreOf) {
  Rigid3d T = Rigid3d::Identity();
  T.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  T.translation() << 10.0, -20.0, 30.0;
  const SceneTriangles scene = Screen(T);
  ASSERT_EQ(scene.triangles.size(), 2u);
  for (const SceneTriangle& triangle : scene.triangles) {
    EXPECT_EQ(triangle.part, 9);
    EXPECT_EQ(scene.surfaces[triangle.surface].instance, 3);
    EXPECT_EQ(scene.surfaces[triangle.surface].label, 4);
    EXPECT_EQ(scene.surfaces[triangle.surface].material, 7);
    const Eigen::Vector3d on_plane = T * Eigen::Vector3d(2.0, 0.1, 0.2);
    EXPECT_NEAR(triangle.normal.dot(on_plane), triangle.offset_m, 1e-12);
    EXPECT_NEAR((triangle.normal + T.linear().col(0)).norm(), 0.0, 1e-7);  // floats in the mesh
  }
}

TEST(SceneTrianglesTest, PointsHaveTextureAndNormalTowardsWhoLooks) {
  const SceneTriangles scene = Screen(Rigid3d::Identity());
  const Eigen::Vector3f position_m(2.0f, 0.0f, 0.0f), ahead(1.0f, 0.0f, 0.0f);
  // The middle of the square is in the middle of the diagonal, which both triangles have.
  const Eigen::Vector2f diagonal(0.0f, 0.5f);
  const SurfacePoint point = PointOn(scene, {}, 0, diagonal, position_m, ahead);
  EXPECT_TRUE(point.texture_m.isApprox(Eigen::Vector2f(0.5f, 0.5f), 1e-6f));
  EXPECT_TRUE(point.normal.isApprox(-ahead, 1e-6f));
  const SurfacePoint from_behind = PointOn(scene, {}, 0, diagonal, position_m, -ahead);
  EXPECT_TRUE(from_behind.normal.isApprox(ahead, 1e-6f));
}

TEST(SceneTrianglesTest, LightOfCornersIsInterpolatedByHowFarItCanBeReliedOn) {
  SceneTriangles scene = Screen(Rigid3d::Identity());
  const Eigen::Vector3i corners = scene.triangles[0].corners;
  scene.corner_light[corners[0]] = LightSample(1, 2, 3, 1);
  scene.corner_light[corners[1]] = LightSample(3, 2, 1, 1);
  scene.corner_light[corners[2]] = LightSample(0, 0, 0, 0);
  const auto light = [&](float u, float v) {
    return PointOn(scene, {}, 0, {u, v}, {2, 0, 0}, {1, 0, 0}).irradiance;
  };
  EXPECT_TRUE(light(0.5f, 0.0f).isApprox(Eigen::Vector3f(2, 2, 2), 1e-6f));
  EXPECT_TRUE(light(0.0f, 0.5f).isApprox(Eigen::Vector3f(1, 2, 3), 1e-6f));
}

}  // namespace
}  // namespace semantic_slam
