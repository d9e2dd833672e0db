#include "semantic_slam/simulation/shader.h"

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "simulation/world_builder.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

const RayScene& Nothing() {
  static const RayScene nothing(RayScene::Lifetime::kStill);
  return nothing;
}

// A floor of each material: dull, polished, shining.
class ShaderTest : public testing::Test {
 protected:
  static World Materials() {
    World world;
    world.materials = {{"plaster", {200, 200, 200}},
                       {"plaster", {200, 200, 200}, 1, {0, 0}, 1.0f, 0.0f},
                       {"plaster", {200, 200, 200}, 1, {0, 0}, 0.0f, 1.0f}};
    return world;
  }

  // Light from the floor below (x_m, 0, 2) towards there, with a lamp of 0.2 m at (2, 0, 2).
  Eigen::Vector3f Floor(int material, float x_m, float irradiance,
                        const RayScene& scene = Nothing()) const {
    SceneSurface surface;
    surface.material = material;
    const SceneTriangle triangle;
    SurfacePoint point;
    point.triangle = &triangle;
    point.surface = &surface;
    point.position_m.setZero();
    point.normal = Eigen::Vector3f::UnitZ();
    point.texture_m = {0.3f, 0.3f};
    const Lamp lamp({{2, 0, 2}, 0.2, {1, 1, 1}});
    return shader_.LightFrom(point, {-x_m, 0, -2}, 0.005f, Eigen::Vector3f::Constant(irradiance),
                             {lamp}, scene);
  }

  const Shader shader_{Materials()};
};

TEST_F(ShaderTest, ADullSurfaceThrowsBackItsShareInAllDirections) {
  const Eigen::Vector3f light = Floor(0, 0.0f, 0.5f);
  EXPECT_EQ(Floor(0, 0.0f, 0.0f).norm(), 0.0f);
  EXPECT_NEAR(Floor(0, 0.0f, 1.0f)[1], 2.0f * light[1], 1e-5f);
  EXPECT_NEAR(Floor(0, -0.5f, 0.5f)[1], light[1], 1e-2f);  // plaster is a little mottled
  // (200 / 255)^2, mottled.
  EXPECT_NEAR(shader_.reflectances()[0].colour[1], 0.615f, 0.06f);
  EXPECT_NEAR(light[1], 0.5f * shader_.reflectances()[0].colour[1], 0.05f);
}

TEST_F(ShaderTest, APolishedSurfaceMirrorsTheLampWhereItShould) {
  EXPECT_GT(Floor(1, -2.0f, 0.5f)[1], Floor(0, -2.0f, 0.5f)[1] + 0.4f);
  EXPECT_NEAR(Floor(1, 2.0f, 0.5f)[1], Floor(0, 2.0f, 0.5f)[1], 1e-2f);
}

TEST_F(ShaderTest, ButNotAHiddenLamp) {
  RayScene scene(RayScene::Lifetime::kStill);
  const Mesh board = BoxMesh({1, 0, 1}, {0.5f, 2, 0.1f});
  scene.SetTriangles(0, board.positions_m, board.triangles, kOpaque);
  scene.Commit();
  EXPECT_NEAR(Floor(1, -2.0f, 0.5f, scene)[1], Floor(0, -2.0f, 0.5f)[1], 1e-2f);
}

TEST_F(ShaderTest, AShiningSurfaceShinesInTheDark) {
  EXPECT_NEAR(Floor(2, 0.0f, 0.0f)[1], kShiningLight * 0.615f, 0.08f);
  EXPECT_EQ(shader_.reflectances()[2].brightness, 1.0f);
}

TEST(ShaderErrorTest, NamesAPatternThatDoesNotExist) {
  World world;
  world.materials = {{"unobtainium", {1, 2, 3}}};
  EXPECT_NE(MessageOf<ConfigError>([&] { Shader shader(world); }).find("unobtainium"),
            std::string::npos);
}

}  // namespace
}  // namespace semantic_slam
