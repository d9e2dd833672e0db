#include "semantic_slam/octree/ray_walk.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

namespace semantic_slam {
namespace {

std::vector<octomap::OcTreeKey> Walk(const octomap::OcTree& tree, const octomap::point3d& from,
                                     const octomap::point3d& to) {
  std::vector<octomap::OcTreeKey> keys;
  RayWalk(tree, from, tree.coordToKey(from), to).ForEachVoxel([&](int x, int y, int z) {
    keys.emplace_back(static_cast<octomap::key_type>(x), static_cast<octomap::key_type>(y),
                      static_cast<octomap::key_type>(z));
  });
  return keys;
}

TEST(RayWalkTest, PassesTheVoxelsThatOctomapPasses) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> coordinate(-3.0f, 3.0f);
  for (const double resolution_m : {0.02, 0.05, 0.3}) {
    const octomap::OcTree tree(resolution_m);
    octomap::KeyRay expected;
    for (int i = 0; i < 500; ++i) {
      const octomap::point3d from(coordinate(random), coordinate(random), coordinate(random));
      // Every other ray ends at a voxel's centre, every fifth runs along an axis.
      octomap::point3d to(coordinate(random), coordinate(random), coordinate(random));
      if (i % 5 == 0) to.y() = from.y(), to.z() = from.z();
      if (i % 2 == 0) to = tree.keyToCoord(tree.coordToKey(to));
      ASSERT_TRUE(tree.computeRayKeys(from, to, expected));
      EXPECT_EQ(Walk(tree, from, to),
                std::vector<octomap::OcTreeKey>(expected.begin(), expected.end()));
    }
  }
}

TEST(RayWalkTest, ARayWithinOneVoxelPassesNone) {
  const octomap::OcTree tree(0.1);
  const octomap::point3d p(0.03f, 0.03f, 0.03f);
  EXPECT_TRUE(Walk(tree, p, p).empty());
  EXPECT_TRUE(Walk(tree, p, {0.09f, 0.01f, 0.05f}).empty());
}

}  // namespace
}  // namespace semantic_slam
