#include "semantic_slam/simulation/ray_scene.h"

#include <gtest/gtest.h>

#include "semantic_slam/worlds/mesh.h"

namespace semantic_slam {
namespace {

const Eigen::Vector3f kOrigin(0.0f, 0.0f, 0.0f), kAhead(1.0f, 0.0f, 0.0f);

void AddWall(RayScene& scene, unsigned id, float x_m, RayMask mask = kOpaque) {
  const Mesh wall = BoxMesh({x_m + 0.5f, 0.0f, 0.0f}, {1.0f, 2.0f, 2.0f});
  scene.SetTriangles(id, wall.positions_m, wall.triangles, mask);
}

RayPacket OneRay(float longest = 100.0f, unsigned mask = kAnySurface) {
  RayPacket packet;
  packet.Clear();
  packet.Set(3, kOrigin, kAhead, longest, mask);
  return packet;
}

TEST(RaySceneTest, FindsTheNearestHitOfLanesThatAreSet) {
  RayScene scene(RayScene::Lifetime::kStill);
  AddWall(scene, 0, 2.0f);
  AddWall(scene, 1, 1.0f);
  scene.Commit();
  RayPacket packet = OneRay();
  packet.Set(5, kOrigin, -kAhead);
  scene.FindHits(packet, true);
  ASSERT_TRUE(packet.IsHit(3));
  EXPECT_EQ(packet.Geometry(3), 1u);
  EXPECT_NEAR(packet.Distance(3), 1.0f, 1e-6f);  // some steps of a float
  EXPECT_TRUE(packet.IsSet(5));
  EXPECT_FALSE(packet.IsHit(5));
  EXPECT_FALSE(packet.IsSet(0));
  EXPECT_FALSE(packet.IsHit(0));
}

TEST(RaySceneTest, KeepsANearerHitOfAnotherScene) {
  RayScene near(RayScene::Lifetime::kStill), far(RayScene::Lifetime::kChanging);
  AddWall(near, 0, 1.0f);
  AddWall(far, 7, 2.0f);
  near.Commit();
  far.Commit();
  RayPacket near_first = OneRay(), far_first = OneRay();
  near.FindHits(near_first, true);
  far.FindHits(near_first, true);
  far.FindHits(far_first, false);
  EXPECT_EQ(far_first.Geometry(3), 7u);
  near.FindHits(far_first, false);
  EXPECT_EQ(near_first.Geometry(3), 0u);
  EXPECT_EQ(far_first.Geometry(3), 0u);
}

TEST(RaySceneTest, FindsWhatIsInTheWay) {
  RayScene scene(RayScene::Lifetime::kStill);
  AddWall(scene, 0, 2.0f);
  scene.Commit();
  RayPacket reaching = OneRay(2.1f), short_of = OneRay(1.9f);
  scene.FindOccluded(reaching);
  scene.FindOccluded(short_of);
  EXPECT_TRUE(reaching.IsOccluded(3));
  EXPECT_FALSE(short_of.IsOccluded(3));
  EXPECT_TRUE(scene.IsOccluded(kOrigin, kAhead, 2.1f));
  EXPECT_FALSE(scene.IsOccluded(kOrigin, kAhead, 1.9f));
}

TEST(RaySceneTest, RaysPassWhatTheirMaskDoesNotName) {
  RayScene scene(RayScene::Lifetime::kStill);
  AddWall(scene, 0, 2.0f, kShining);
  scene.Commit();
  RayPacket opaque_only = OneRay(100.0f, kOpaque), any = OneRay(100.0f, kAnySurface);
  scene.FindHits(opaque_only, true);
  scene.FindHits(any, true);
  EXPECT_FALSE(opaque_only.IsHit(3));
  EXPECT_TRUE(any.IsHit(3));
}

TEST(RaySceneTest, AGeometryIsReplacedOrTakenAway) {
  RayScene scene(RayScene::Lifetime::kChanging);
  AddWall(scene, 2, 1.0f);
  scene.Commit();
  AddWall(scene, 2, 3.0f);
  scene.Commit();
  RayPacket packet = OneRay();
  scene.FindHits(packet, true);
  EXPECT_NEAR(packet.Distance(3), 3.0f, 1e-6f);
  scene.SetTriangles(2, {}, {}, kOpaque);
  scene.Commit();
  RayPacket after = OneRay();
  scene.FindHits(after, true);
  EXPECT_FALSE(after.IsHit(3));
}

TEST(RaySceneTest, NothingIsHitInAnEmptyScene) {
  const RayScene scene(RayScene::Lifetime::kStill);
  RayPacket packet = OneRay();
  scene.FindHits(packet, true);
  scene.FindOccluded(packet);
  EXPECT_FALSE(packet.IsHit(3));
  EXPECT_FALSE(packet.IsOccluded(3));
}

}  // namespace
}  // namespace semantic_slam
