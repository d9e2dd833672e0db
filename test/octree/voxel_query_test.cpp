#include "semantic_slam/octree/voxel_query.h"

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

constexpr LabelId kFloor = 2, kTable = 7, kCeiling = 22;

class VoxelQueryTest : public testing::Test {
 protected:
  VoxelQueryTest() { AddRoom(tree_); }

  SemanticOcTree tree_{0.1};
};

TEST_F(VoxelQueryTest, CountsTheVoxelsOfEachClass) {
  const VoxelsFound found = FindVoxels(tree_, {});
  ASSERT_EQ(found.labels.size(), 3u);
  EXPECT_EQ(found.labels[0].label, kFloor);
  EXPECT_EQ(found.labels[0].voxels, 20u * 10u);
  EXPECT_EQ(found.labels[1].label, kTable);
  EXPECT_EQ(found.labels[1].voxels, 5u * 5u);
  EXPECT_EQ(found.labels[2].label, kCeiling);
  EXPECT_EQ(found.voxels, 2u * 200u + 25u);
}

TEST_F(VoxelQueryTest, FindsTheNearestOfAClass) {
  VoxelQuery query;
  query.label = kTable;
  query.near_m = {0.0, 0.5, 0.75};
  const VoxelsFound found = FindVoxels(tree_, query);
  ASSERT_TRUE(found.nearest);
  EXPECT_EQ(found.nearest->label, kTable);
  EXPECT_NEAR(found.nearest->centre_m.x(), 0.55, 1e-6);
  EXPECT_NEAR(found.nearest->centre_m.z(), 0.75, 1e-6);
  EXPECT_NEAR(found.nearest->distance_m, std::hypot(0.55, 0.05), 1e-6);
  query.label = 31;
  EXPECT_FALSE(FindVoxels(tree_, query).nearest);
}

TEST_F(VoxelQueryTest, LooksInABoxOnly) {
  VoxelQuery query;
  query.box_m =
      Eigen::AlignedBox3d(Eigen::Vector3d(0.0, 0.0, 0.5), Eigen::Vector3d(0.72, 1.0, 1.0));
  const VoxelsFound found = FindVoxels(tree_, query);
  ASSERT_EQ(found.labels.size(), 1u);
  EXPECT_EQ(found.labels[0].voxels, 2u * 5u);  // centres at 0.55 and 0.65
  query.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(5, 5, 5), Eigen::Vector3d(6, 6, 6));
  EXPECT_EQ(FindVoxels(tree_, query).voxels, 0u);
}

// Blocks count as the voxels that they stand for.
TEST_F(VoxelQueryTest, ABlockIsItsVoxels) {
  SemanticOcTree tree(0.1);
  for (int i = 0; i < 8; ++i)
    AddVoxel(tree, {0.05 + 0.1 * (i & 1), 0.05 + 0.1 * (i >> 1 & 1), 0.05 + 0.1 * (i >> 2)},
             kTable);
  tree.updateInnerOccupancy();
  tree.prune();
  ASSERT_EQ(tree.getNumLeafNodes(), 1u);
  EXPECT_EQ(FindVoxels(tree, {}).voxels, 8u);
  VoxelQuery half;
  half.box_m = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.1, 0.2, 0.2));
  EXPECT_EQ(FindVoxels(tree, half).voxels, 4u);
}

TEST_F(VoxelQueryTest, TellsTheStateOfAVoxel) {
  tree_.setNodeValue(0.05, 0.05, 1.05, -1.0f);
  const VoxelState table = StateAt(tree_, {0.72, 0.52, 0.72});
  EXPECT_TRUE(table.is_known);
  EXPECT_TRUE(table.is_occupied);
  EXPECT_EQ(table.labels.top(), kTable);
  EXPECT_NEAR(table.labels.probabilities[0], 0.8f, 1e-3f);
  const VoxelState free = StateAt(tree_, {0.05, 0.05, 1.05});
  EXPECT_TRUE(free.is_known);
  EXPECT_FALSE(free.is_occupied);
  EXPECT_LT(free.occupancy, 0.5f);
  EXPECT_FALSE(StateAt(tree_, {1.5, 0.05, 1.05}).is_known);
  EXPECT_FALSE(StateAt(tree_, {1e9, 0.0, 0.0}).is_known);
  EXPECT_FALSE(StateAt(SemanticOcTree(0.1), {0.0, 0.0, 0.0}).is_known);
}

}  // namespace
}  // namespace semantic_slam
