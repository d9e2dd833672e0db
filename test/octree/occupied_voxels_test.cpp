#include "semantic_slam/octree/occupied_voxels.h"

#include <set>

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

// A block of eight joined voxels of occupied space, a single one, and a free one.
void Fill(SemanticOcTree& tree) {
  for (int i = 0; i < 8; ++i) {
    AddVoxel(tree, {0.05 + 0.1 * (i & 1), 0.05 + 0.1 * (i >> 1 & 1), 0.05 + 0.1 * (i >> 2)}, 7);
  }
  AddVoxel(tree, {-0.95, 0.05, 0.05}, 5);
  tree.setNodeValue(3.0, 3.0, 3.0, -1.0f, true);
  tree.updateInnerOccupancy();
  tree.prune();
}

TEST(OccupiedVoxelsTest, LeavesKeepTheirSize) {
  SemanticOcTree tree(0.1);
  Fill(tree);
  std::multiset<double> sizes;
  ForEachOccupiedLeaf(tree, [&](const Eigen::Vector3d& centre, double size_m,
                                const SemanticNode& node) {
    sizes.insert(size_m);
    if (node.labels().label(0) == 7) {
      EXPECT_TRUE(centre.isApprox(Eigen::Vector3d(0.1, 0.1, 0.1), 1e-6));  // coordinates are float
    }
  });
  EXPECT_EQ(sizes, (std::multiset<double>{0.1, 0.2}));
}

TEST(OccupiedVoxelsTest, VoxelsOfABlockComeOneByOne) {
  SemanticOcTree tree(0.1);
  Fill(tree);
  std::set<std::array<int, 3>> keys;
  ForEachOccupiedVoxel(tree, [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
    EXPECT_TRUE(keys.insert({key[0] - 32768, key[1] - 32768, key[2] - 32768}).second);
    EXPECT_EQ(node.labels().label(0), key[0] >= 32768 ? 7 : 5);
  });
  EXPECT_EQ(keys.size(), 9u);
  EXPECT_EQ(keys.count({1, 0, 1}), 1u);
  EXPECT_EQ(keys.count({-10, 0, 0}), 1u);
}

TEST(OccupiedVoxelsTest, AnEmptyTreeHasNone) {
  const SemanticOcTree tree(0.1);
  ForEachOccupiedVoxel(tree, [](const octomap::OcTreeKey&, const SemanticNode&) { FAIL(); });
  ForEachOccupiedLeaf(tree, [](const Eigen::Vector3d&, double, const SemanticNode&) { FAIL(); });
}

}  // namespace
}  // namespace semantic_slam
