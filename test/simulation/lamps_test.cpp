#include "semantic_slam/simulation/lamps.h"

#include <gtest/gtest.h>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {
namespace {

const Eigen::Vector3f kUp = Eigen::Vector3f::UnitZ();

Lamp LampAt2m(double side_m = 0.4) {
  return Lamp({{0.0, 0.0, 2.0}, side_m, {1.0f, 0.5f, 0.25f}});
}

TEST(LampsTest, IsOfStrengthOneOnTheFloor2mBelow) {
  const Lamp lamp = LampAt2m();
  EXPECT_NEAR(lamp.Strength({0, 0, 0}, kUp), 1.0f, 1e-6f);
  // At 45 degrees: half for either cosine, twice the squared distance.
  EXPECT_NEAR(lamp.Strength({2, 0, 0}, kUp), 0.25f, 1e-6f);
  EXPECT_EQ(lamp.Strength({0, 0, 0}, -kUp), 0.0f);
  EXPECT_EQ(lamp.Strength({0, 0, 3}, -kUp), 0.0f) << "lamps shine downwards";
}

TEST(LampsTest, LightOfAllThatIsInSightAddsUp) {
  const RayScene nothing(RayScene::Lifetime::kStill);
  const LampLight both = LightOf({LampAt2m(), LampAt2m()}, nothing, {0, 0, 0}, kUp);
  EXPECT_EQ(both.lamps, OnlyLamp(0) | OnlyLamp(1));
  const Eigen::Vector3f light = both.irradiance;
  // 4 %: the lamp's rim is farther away than its middle.
  EXPECT_NEAR(light[2], 2.0f, 0.08f);
  EXPECT_NEAR(light[1] / light[2], 0.5f, 1e-5f);
  EXPECT_NEAR(light[0] / light[2], 0.25f, 1e-5f);
}

TEST(LampsTest, EdgesThrowSoftShadows) {
  RayScene scene(RayScene::Lifetime::kStill);
  const Mesh board = BoxMesh({1.0f, 0.0f, 1.0f}, {2.0f, 4.0f, 0.02f});  // over x > 0
  scene.SetTriangles(0, board.positions_m, board.triangles, kOpaque);
  scene.Commit();
  const std::vector<Lamp> lamps{LampAt2m(0.4)};
  const auto light_at = [&](float x_m) {
    return LightOf(lamps, scene, {x_m, 0, 0}, kUp).irradiance[2];
  };
  // The edge is half way up, so the half shadow is as wide as the lamp: from -0.2 m to 0.2 m.
  EXPECT_EQ(light_at(0.3f), 0.0f);
  EXPECT_EQ(LightOf(lamps, scene, {0.3f, 0, 0}, kUp).lamps, 0u);
  EXPECT_NEAR(light_at(0.0f), 0.5f, 0.06f);  // a ray of 16
  EXPECT_GT(light_at(-0.3f), 0.9f);
  float before = 1.1f;
  for (float x_m = -0.2f; x_m <= 0.2f; x_m += 0.025f) {
    EXPECT_LE(light_at(x_m), before);
    EXPECT_GE(light_at(x_m), before - 0.2f) << "a step in the shadow at " << x_m;
    before = light_at(x_m);
  }
}

TEST(LampsTest, SaysHowMuchOfALampIsInSight) {
  RayScene scene(RayScene::Lifetime::kStill);
  EXPECT_EQ(VisibleShare(LampAt2m(), scene, {0, 0, 1}), 1.0f);
  const Mesh board = BoxMesh({1.0f, 0.0f, 1.0f}, {2.0f, 4.0f, 0.02f});
  scene.SetTriangles(0, board.positions_m, board.triangles, kOpaque);
  scene.Commit();
  EXPECT_NEAR(VisibleShare(LampAt2m(), scene, {0, 0, 0}), 0.5f, 0.07f);
  EXPECT_EQ(VisibleShare(LampAt2m(), scene, {1, 0, 0}), 0.0f);
}

}  // namespace
}  // namespace semantic_slam
