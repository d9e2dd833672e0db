#include "semantic_slam/octree/ray_layer.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

#include "semantic_slam/octree/tree_updater.h"

namespace semantic_slam {
namespace {

constexpr double kResolutionM = 0.05;

using Keys = std::set<std::array<int, 3>>;

ScanLayout Around(const SemanticOcTree& tree, double reach_m) {
  ScanLayout layout;
  layout.Reset(tree.coordToKey(-reach_m, -reach_m, -reach_m),
               tree.coordToKey(reach_m, reach_m, reach_m));
  return layout;
}

Keys MarkedIn(const RayLayer& rays, const ScanLayout& layout) {
  Keys keys;
  rays.ForEachBrick([&](std::uint32_t brick, const std::array<std::uint64_t, 8>& words) {
    for (unsigned place = 0; place < 512; ++place) {
      if ((words[place >> 6] >> (place & 63) & 1) == 0) continue;
      const octomap::OcTreeKey key = ScanLayout::KeyOf(layout.CornerOf(brick), place);
      keys.insert({key[0], key[1], key[2]});
    }
  });
  return keys;
}

Keys Walked(RayWalk ray) {
  Keys keys;
  ray.ForEachVoxel([&](int x, int y, int z) { keys.insert({x, y, z}); });
  return keys;
}

// Rays of all directions, some along an axis or a diagonal, where borders coincide.
std::vector<octomap::point3d> Ends(const SemanticOcTree& tree, std::mt19937& random) {
  std::uniform_real_distribution<float> coordinate(-3.0f, 3.0f);
  std::vector<octomap::point3d> ends;
  for (int i = 0; i < 1500; ++i) {
    octomap::point3d end(coordinate(random), coordinate(random), coordinate(random));
    if (i % 7 == 0) end.y() = end.x();
    if (i % 11 == 0) end.z() = -end.x();
    if (i % 13 == 0) end.y() = 0.0f;
    if (i % 17 == 0) end.z() = 0.0f;
    ends.push_back(i % 2 == 0 ? tree.keyToCoord(tree.coordToKey(end)) : end);
  }
  return ends;
}

TEST(RayLayerTest, MarksWhatTheRayPasses) {
  std::mt19937 random(3);
  const SemanticOcTree tree(kResolutionM);
  const ScanLayout layout = Around(tree, 3.1);
  const octomap::OcTreeKey centre_key = tree.coordToKey(0.0, 0.0, 0.0);
  RayLayer rays;
  // From a voxel's centre many borders are met at once.
  for (const octomap::point3d& origin :
       {tree.keyToCoord(centre_key), octomap::point3d(0.013f, 0.021f, 0.048f)}) {
    for (const octomap::point3d& end : Ends(tree, random)) {
      const RayWalk ray(tree, origin, centre_key, end);
      rays.Reset(layout, tree);
      rays.Mark(ray);
      ASSERT_EQ(MarkedIn(rays, layout), Walked(ray)) << end.x() << ' ' << end.y() << ' ' << end.z();
    }
  }
}

// Half of the space is as free as it can be: no mark is needed there, and none elsewhere is
// missing.
TEST(RayLayerTest, LeavesOutOnlyBricksThatAreAsFreeAsCanBe) {
  std::mt19937 random(4);
  SemanticOcTree tree(kResolutionM);
  tree.SetOccupancy({});
  const ScanLayout layout = Around(tree, 3.1);
  std::set<std::uint64_t> settled;
  for (std::size_t brick = 0; brick < layout.bricks(); ++brick) {
    if (random() % 2 == 0) continue;
    ScanGrid::Brick all;
    all.corner = layout.CornerOf(brick);
    all.free.fill(~std::uint64_t{0});
    for (int i = 0; i < 6; ++i)
      TreeUpdater(tree).Update(all, [](SemanticNode&, bool, unsigned) { FAIL(); });
    settled.insert(brick);
  }
  const octomap::point3d origin(0.013f, 0.021f, 0.048f);
  const octomap::OcTreeKey origin_key = tree.coordToKey(origin);
  RayLayer rays;
  rays.Reset(layout, tree);
  Keys expected;
  for (const octomap::point3d& end : Ends(tree, random)) {
    const RayWalk ray(tree, origin, origin_key, end);
    rays.Mark(ray);
    for (const auto& [x, y, z] : Walked(ray)) {
      const auto brick = (layout.On(0, x) + layout.On(1, y) + layout.On(2, z)) >> 9;
      if (settled.count(brick) == 0) expected.insert({x, y, z});
    }
  }
  ASSERT_GT(expected.size(), 20000u);
  EXPECT_EQ(MarkedIn(rays, layout), expected);
}

}  // namespace
}  // namespace semantic_slam
