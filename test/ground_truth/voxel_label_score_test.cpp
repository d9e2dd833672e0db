#include "semantic_slam/ground_truth/voxel_label_score.h"

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"

namespace semantic_slam {
namespace {

// Makes the voxel around `p` occupied, of that class by so many observations.
void AddVoxel(SemanticOcTree& tree, const Eigen::Vector3d& p, LabelId label, int observations = 1) {
  LabelDistribution distribution;
  distribution.labels[0] = label;
  distribution.probabilities[0] = label == kUnknownLabel ? 0.0f : 0.8f;
  distribution.observations = observations;
  tree.setNodeValue(p.x(), p.y(), p.z(), 2.0f, true)->SetLabels(CompactLabels(distribution));
}

VoxelLabelScore Score(const SemanticOcTree& tree,
                      const Rigid3d& T_world_map = Rigid3d::Identity()) {
  return ScoreVoxelLabels(tree, T_world_map, SurfaceLabels(SmallWorld()));
}

TEST(VoxelLabelScoreTest, CountsRightWrongAndUnlabelledOnes) {
  SemanticOcTree tree(0.05);
  AddVoxel(tree, {1.02, 1.02, 0.02}, kFloor);
  AddVoxel(tree, {1.22, 1.02, 0.02}, kFloor);
  AddVoxel(tree, {1.42, 1.02, 0.02}, kChair);
  AddVoxel(tree, {1.62, 1.02, 0.02}, kUnknownLabel);
  AddVoxel(tree, {2.02, 1.52, 0.72}, kTable);
  const VoxelLabelScore score = Score(tree);
  EXPECT_EQ(score.occupied, 5u);
  EXPECT_EQ(score.without_surface, 0u);
  EXPECT_EQ(score.unlabelled, 1u);
  EXPECT_EQ(score.all.voxels, 5u);
  EXPECT_EQ(score.all.right, 3u);
  EXPECT_DOUBLE_EQ(score.all.share(), 0.6);
  EXPECT_EQ(score.by_class.at(kFloor).voxels, 4u);
  EXPECT_EQ(score.by_class.at(kFloor).right, 2u);
  EXPECT_EQ(score.by_class.at(kTable).right, 1u);
  EXPECT_EQ(score.by_class.size(), 2u);
}

TEST(VoxelLabelScoreTest, WhatFloatsInTheAirHasNoSurface) {
  SemanticOcTree tree(0.05);
  AddVoxel(tree, {1.02, 1.02, 1.02}, kFloor);
  AddVoxel(tree, {1.02, 1.02, 0.07}, kFloor);  // its centre is 7.5 cm high
  AddVoxel(tree, {1.02, 1.02, 0.02}, kFloor);
  const VoxelLabelScore score = Score(tree);
  EXPECT_EQ(score.without_surface, 2u);
  EXPECT_EQ(score.all.voxels, 1u);
}

TEST(VoxelLabelScoreTest, AVoxelThatTwoClassesPassMayBeEither) {
  SemanticOcTree tree(0.05);
  AddVoxel(tree, {0.02, 1.52, 0.02}, kFloor);  // in the corner of floor and wall
  AddVoxel(tree, {0.02, 1.62, 0.02}, kWall);
  AddVoxel(tree, {0.02, 1.72, 0.02}, kTable);
  const VoxelLabelScore score = Score(tree);
  EXPECT_EQ(score.all.right, 2u);
  EXPECT_EQ(score.strict.voxels, 3u);
  EXPECT_EQ(score.strict.right, 1u);
}

TEST(VoxelLabelScoreTest, FollowsTheMapsPose) {
  SemanticOcTree tree(0.05);
  AddVoxel(tree, {0.02, 0.02, -1.18}, kFloor);  // the map begins 1.2 m over the floor
  EXPECT_EQ(Score(tree).all.right, 0u);
  Rigid3d T_world_map = Rigid3d::Identity();
  T_world_map.translation() << 1.0, 1.0, 1.2;
  EXPECT_EQ(Score(tree, T_world_map).all.right, 1u);
}

TEST(VoxelLabelScoreTest, LabelsCountAsTheirClass) {
  SemanticOcTree tree(0.05);
  AddVoxel(tree, {1.02, 1.02, 0.02}, kFloor);  // is floor, which counts as wall
  AddVoxel(tree, {1.22, 1.02, 0.02}, kWall);   // the same
  AddVoxel(tree, {1.42, 1.02, 0.02}, kChair);  // counts as nothing
  AddVoxel(tree, {2.02, 1.52, 0.72}, kTable);  // is a table, which does not count
  ClassList classes;
  classes.Add("wall", kWall);
  classes.of_label[kFloor] = classes.of_label[kWall];
  const VoxelLabelScore score =
      ScoreVoxelLabels(tree, Rigid3d::Identity(), SurfaceLabels(SmallWorld()), &classes);
  EXPECT_EQ(score.occupied, 4u);
  EXPECT_EQ(score.not_counted, 1u);
  EXPECT_EQ(score.unlabelled, 1u);
  EXPECT_EQ(score.all.voxels, 3u);
  EXPECT_EQ(score.all.right, 2u);
  EXPECT_EQ(score.by_class.size(), 1u);
}

TEST(VoxelLabelScoreTest, SortsByObservations) {
  SemanticOcTree tree(0.05);
  const int observations[] = {1, 2, 3, 4, 15, 16, 40, 63};
  for (int i = 0; i < 8; ++i) AddVoxel(tree, {1.02 + 0.1 * i, 0.52, 0.02}, kFloor, observations[i]);
  const VoxelLabelScore score = Score(tree);
  const std::size_t expected[] = {1, 2, 1, 1, 1, 2};
  for (int i = 0; i < VoxelLabelScore::kObservationBins; ++i) {
    EXPECT_EQ(score.by_observations[i].voxels, expected[i]) << i;
  }
}

TEST(VoxelLabelScoreTest, CountsTheVoxelsOfABlock) {
  SemanticOcTree tree(0.05);
  for (int i = 0; i < 8; ++i) {
    AddVoxel(tree, {1.01 + 0.05 * (i & 1), 1.01 + 0.05 * (i >> 1 & 1), -0.09 + 0.05 * (i >> 2)},
             kFloor);
  }
  tree.updateInnerOccupancy();
  tree.prune();
  EXPECT_EQ(Score(tree).occupied, 8u);
}

TEST(VoxelLabelScoreTest, AnEmptyMapHasNothingRight) {
  const VoxelLabelScore score = Score(SemanticOcTree(0.05));
  EXPECT_EQ(score.occupied, 0u);
  EXPECT_EQ(score.all.share(), 0.0);
}

}  // namespace
}  // namespace semantic_slam
