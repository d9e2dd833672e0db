#include "semantic_slam/octree/anchored_clouds.h"

#include <gtest/gtest.h>

#include "octree/octree_testing.h"

namespace semantic_slam {
namespace {

AnchoredCloud Cloud(int index, std::size_t points = 100) {
  AnchoredCloud cloud;
  cloud.stamp.ns = index;
  cloud.keyframe_id = index / 10;
  cloud.observations.assign(points, Observation({0, 0, 1}, 5, 0.5f));
  return cloud;
}

TEST(AnchoredCloudsTest, KeepsAllWithinTheBudget) {
  AnchoredClouds clouds(1 << 20);
  for (int i = 0; i < 100; ++i) clouds.Add(Cloud(i));
  EXPECT_EQ(clouds.clouds().size(), 100u);
  EXPECT_EQ(clouds.keeps_one_of(), 1u);
  EXPECT_GE(clouds.bytes(), 100 * 100 * sizeof(VoxelObservation));
}

TEST(AnchoredCloudsTest, ThinsEvenlyPastTheBudget) {
  const std::size_t budget = 50 * 100 * sizeof(VoxelObservation);
  AnchoredClouds clouds(budget);
  for (int i = 0; i < 1000; ++i) {
    clouds.Add(Cloud(i));
    EXPECT_LE(clouds.bytes(), budget);
  }
  EXPECT_EQ(clouds.keeps_one_of(), 32u);
  ASSERT_GE(clouds.clouds().size(), 25u);
  for (std::size_t i = 0; i < clouds.clouds().size(); ++i) {
    EXPECT_EQ(clouds.clouds()[i].stamp.ns, static_cast<std::int64_t>(32 * i));
  }
}

TEST(AnchoredCloudsTest, ACloudBeyondTheBudgetIsNotKept) {
  AnchoredClouds clouds(1000);
  clouds.Add(Cloud(0, 10000));
  EXPECT_TRUE(clouds.clouds().empty());
  EXPECT_EQ(clouds.bytes(), 0u);
}

TEST(AnchoredCloudsTest, RemovesAndForgets) {
  AnchoredClouds clouds(1 << 20);
  for (int i = 0; i < 30; ++i) clouds.Add(Cloud(i));
  const std::size_t bytes = clouds.bytes();
  EXPECT_EQ(clouds.RemoveIf([](const AnchoredCloud& cloud) { return cloud.keyframe_id == 1; }),
            10u);
  EXPECT_EQ(clouds.clouds().size(), 20u);
  EXPECT_EQ(clouds.bytes(), bytes / 3 * 2);
  clouds.Clear();
  EXPECT_EQ(clouds.bytes(), 0u);
  EXPECT_TRUE(clouds.clouds().empty());
}

}  // namespace
}  // namespace semantic_slam
