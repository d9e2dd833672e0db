#include "semantic_slam/octree/clear_box.h"

#include <gtest/gtest.h>

#include "octree/octree_testing.h"
#include "semantic_slam/octree/voxel_query.h"

namespace semantic_slam {
namespace {

TEST(ClearBoxTest, MakesWhatIsOccupiedInItFree) {
  SemanticOcTree tree(0.1);
  tree.SetOccupancy({});
  AddRoom(tree);
  const std::size_t before = FindVoxels(tree, {}).voxels;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0.0, 0.0, 0.5), Eigen::Vector3d(2.0, 1.0, 1.0));
  EXPECT_EQ(ClearBox(box, tree), 25u);  // the table
  EXPECT_EQ(FindVoxels(tree, {}).voxels, before - 25);
  const VoxelState cleared = StateAt(tree, {0.72, 0.52, 0.72});
  EXPECT_TRUE(cleared.is_known);
  EXPECT_FALSE(cleared.is_occupied);
  EXPECT_NEAR(cleared.occupancy, OccupancyOptions().clamp_min, 1e-5);
  EXPECT_FALSE(StateAt(tree, {0.2, 0.2, 0.72}).is_known);  // was not known, and is not
  EXPECT_EQ(tree.size(), tree.calcNumNodes());
  EXPECT_EQ(ClearBox(box, tree), 0u);
}

TEST(ClearBoxTest, AnEmptyMapIsNoError) {
  SemanticOcTree tree(0.1);
  EXPECT_EQ(ClearBox({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)}, tree), 0u);
  EXPECT_EQ(tree.getRoot(), nullptr);
}

}  // namespace
}  // namespace semantic_slam
