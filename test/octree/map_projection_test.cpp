#include "semantic_slam/octree/map_projection.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

std::size_t Count(const ProjectedMap& map, std::int8_t cell) {
  return static_cast<std::size_t>(std::count(map.cells.begin(), map.cells.end(), cell));
}

TEST(MapProjectionTest, WithoutFloorAndCeilingTheTableIsLeft) {
  SemanticOcTree tree(0.1);
  AddRoom(tree);
  tree.setNodeValue(-0.95, 0.05, 1.05, -1.0f);  // free, beside the room
  MapProjectionOptions options;
  options.left_out.set(2);
  options.left_out.set(22);
  const ProjectedMap map = ProjectDown(tree, options);
  EXPECT_EQ(map.width, 30);
  EXPECT_EQ(map.height, 10);
  EXPECT_NEAR(map.origin_m.x(), -1.0, 1e-6);
  EXPECT_NEAR(map.origin_m.y(), 0.0, 1e-6);
  EXPECT_EQ(Count(map, ProjectedMap::kOccupied), 25u);
  EXPECT_EQ(map.cells[5 * 30 + 10 + 7], ProjectedMap::kOccupied);  // (0.75, 0.55)
  EXPECT_EQ(map.cells[0], ProjectedMap::kFree);
  EXPECT_EQ(map.cells[5], ProjectedMap::kUnknown);
  EXPECT_EQ(Count(map, ProjectedMap::kFree), 200u - 25u + 1u);
}

TEST(MapProjectionTest, LooksAtHeightsOnly) {
  SemanticOcTree tree(0.1);
  AddRoom(tree);
  MapProjectionOptions options;
  options.min_z_m = 0.3;
  options.max_z_m = 1.0;
  const ProjectedMap map = ProjectDown(tree, options);
  EXPECT_EQ(map.width * map.height, 25);
  EXPECT_EQ(Count(map, ProjectedMap::kOccupied), 25u);
}

TEST(MapProjectionTest, AnEmptyMapHasNoCells) {
  const ProjectedMap map = ProjectDown(SemanticOcTree(0.1), {});
  EXPECT_EQ(map.width, 0);
  EXPECT_TRUE(map.cells.empty());
}

}  // namespace
}  // namespace semantic_slam
