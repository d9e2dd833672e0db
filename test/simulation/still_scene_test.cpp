#include "semantic_slam/simulation/still_scene.h"

#include <gtest/gtest.h>

#include "simulation/world_builder.h"

namespace semantic_slam {
namespace {

TEST(StillSceneTest, HoldsAllButWhatMoves) {
  WorldBuilder builder;
  builder.Add(3, BoxMesh({0, 0, 0}, {1, 1, 1}));
  builder.Add(4, BoxMesh({5, 0, 0}, {1, 1, 1})).walk = Walk({{0, 0}, {1, 0}}, 1.0);
  builder.Add(9, BoxMesh({9, 0, 0}, {1, 1, 1})).surfaces[0].swing = Swing();
  const StillScene scene(builder.world());
  EXPECT_EQ(scene.triangles().triangles.size(), 12u);
  EXPECT_EQ(scene.part_count(), 6);
}

TEST(StillSceneTest, FindsWhatARayMeetsAlsoAmongWhatShines) {
  WorldBuilder builder;
  Material shining;
  shining.brightness = 1.0f;
  const int lamp = builder.AddMaterial(shining);
  builder.Add(9, BoxMesh({3, 0, 0}, {1, 1, 1}), lamp);
  builder.Add(4, BoxMesh({0, 3, 0}, {1, 1, 1}));
  const StillScene scene(builder.world());
  RayPacket packet;
  packet.Clear();
  packet.Set(0, {0, 0, 0}, {1, 0, 0});
  packet.Set(1, {0, 0, 0}, {0, 1, 0});
  packet.Set(2, {0, 0, 0}, {1, 0, 0}, 100.0f, kOpaque);
  scene.rays().FindHits(packet, false);
  ASSERT_TRUE(packet.IsHit(0) && packet.IsHit(1));
  EXPECT_EQ(scene.PointAt(packet, 0, {2.5f, 0, 0}, {1, 0, 0}).surface->label, 9);
  EXPECT_EQ(scene.PointAt(packet, 1, {0, 2.5f, 0}, {0, 1, 0}).surface->label, 4);
  EXPECT_FALSE(packet.IsHit(2)) << "what shines throws no shadow";
}

TEST(StillSceneTest, TakesTheLightAtItsSites) {
  WorldBuilder builder;
  builder.Add(3, BoxMesh({0, 0, 0}, {2, 2, 2}));
  builder.Add(9, EllipsoidMesh({5, 0, 0}, {1, 1, 1}));
  StillScene scene(builder.world());
  std::vector<LightSample> light;
  for (const LightSite& site : scene.sites()) {
    light.emplace_back(site.position_m.x(), 0, 0, 1);
  }
  EXPECT_EQ(scene.SiteRanges().size(), scene.grids().size() + 2);
  EXPECT_EQ(scene.SiteRanges().back(), light.size());
  scene.SetLight(light);
  RayPacket packet;
  packet.Clear();
  packet.Set(0, {0.3f, 0, 5}, {0, 0, -1});
  packet.Set(1, {5.1f, 0, 5}, {0, 0, -1});
  scene.rays().FindHits(packet, false);
  ASSERT_TRUE(packet.IsHit(0) && packet.IsHit(1));
  EXPECT_NEAR(scene.PointAt(packet, 0, {0.3f, 0, 1}, {0, 0, -1}).irradiance[0], 0.3f, 0.006f);
  EXPECT_NEAR(scene.PointAt(packet, 1, {5.1f, 0, 1}, {0, 0, -1}).irradiance[0], 5.1f, 0.02f);
}

}  // namespace
}  // namespace semantic_slam
