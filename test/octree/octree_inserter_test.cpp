#include "semantic_slam/octree/octree_inserter.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "octree/octree_testing.h"
#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr double kResolutionM = 0.1;
constexpr LabelId kChair = 5, kPerson = 31;

// Points all around the camera, from near to well beyond the range, some twice.
std::vector<VoxelObservation> RandomScan(std::mt19937& random, int count) {
  std::normal_distribution<float> coordinate(0.0f, 2.5f);
  std::vector<VoxelObservation> scan;
  for (int i = 0; i < count; ++i) {
    scan.push_back(
        Observation({coordinate(random), coordinate(random), coordinate(random)}, kChair, 0.8f));
    if (i % 5 == 0) scan.push_back(scan.back());
  }
  return scan;
}

Rigid3d RandomPose(std::mt19937& random) {
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  Rigid3d pose = Rigid3d::Identity();
  pose.linear() =
      ExpSo3(3.0 * Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random)));
  pose.translation() =
      4.0 * Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
  return pose;
}

octomap::point3d ToPoint(const Eigen::Vector3d& p) {
  return octomap::point3d(static_cast<float>(p.x()), static_cast<float>(p.y()),
                          static_cast<float>(p.z()));
}

// What OctoMap itself makes of the same points.
void InsertByOctomap(const std::vector<VoxelObservation>& scan, const Rigid3d& T_map_camera,
                     double range_m, octomap::OcTree& tree) {
  octomap::Pointcloud cloud;
  for (const VoxelObservation& point : scan)
    cloud.push_back(ToPoint(T_map_camera * point.position.cast<double>()));
  tree.insertPointCloud(cloud, ToPoint(T_map_camera.translation()), range_m, true, true);
}

template <typename Tree>
void SetLikeOptions(Tree& tree, const OccupancyOptions& options) {
  tree.setProbHit(options.hit);
  tree.setProbMiss(options.miss);
  tree.setClampingThresMin(options.clamp_min);
  tree.setClampingThresMax(options.clamp_max);
}

TEST(OctreeInserterTest, OccupancyIsOctomapsToTheBit) {
  std::mt19937 random(7);
  OctreeInserterOptions options;
  options.max_hit_range_m = options.max_clear_range_m = 4.0;
  OctreeInserter inserter(options, Bayes());
  SemanticOcTree tree(kResolutionM);
  octomap::OcTree expected(kResolutionM);
  tree.SetOccupancy({});
  SetLikeOptions(expected, {});
  for (int scan = 0; scan < 12; ++scan) {
    const auto points = RandomScan(random, 400);
    // Every third view again, so that voxels reach the clamps, and blocks are pruned and expanded.
    const Rigid3d pose = RandomPose(random);
    for (int again = 0; again < (scan % 3 == 0 ? 6 : 1); ++again) {
      inserter.Insert(points, pose, tree);
      InsertByOctomap(points, pose, options.max_clear_range_m, expected);
    }
  }
  expected.updateInnerOccupancy();
  expected.prune();
  ASSERT_GT(expected.getNumLeafNodes(), 10000u);
  EXPECT_LT(tree.getNumLeafNodes(), tree.calcNumNodes());
  EXPECT_FLOAT_EQ(tree.getRoot()->getLogOdds(), expected.getRoot()->getLogOdds());
  EXPECT_EQ(tree.size(), tree.calcNumNodes());
  tree.expand();
  expected.expand();
  EXPECT_EQ(tree.getNumLeafNodes(), expected.getNumLeafNodes());
  std::size_t differing = 0;
  for (auto leaf = expected.begin_leafs(); leaf != expected.end_leafs(); ++leaf) {
    const SemanticNode* ours = tree.search(leaf.getKey());
    differing += ours == nullptr || ours->getLogOdds() != leaf->getLogOdds();
  }
  EXPECT_EQ(differing, 0u);
}

TEST(OctreeInserterTest, PrunesFreeSpaceAsFarAsOctomapDoes) {
  std::mt19937 random(3);
  OctreeInserter inserter({}, Bayes());
  SemanticOcTree tree(kResolutionM);
  octomap::OcTree expected(kResolutionM);
  tree.SetOccupancy({});
  SetLikeOptions(expected, {});
  const auto points = RandomScan(random, 3000);
  for (int scan = 0; scan < 8; ++scan) {
    inserter.Insert(points, Rigid3d::Identity(), tree);
    InsertByOctomap(points, Rigid3d::Identity(), 5.0, expected);
  }
  expected.updateInnerOccupancy();
  expected.prune();
  // All hits say the same, so labels prevent no pruning here.
  EXPECT_EQ(tree.getNumLeafNodes(), expected.getNumLeafNodes());
  std::size_t free_blocks = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf)
    free_blocks += leaf.getDepth() < 16;
  EXPECT_GT(free_blocks, 100u);
}

TEST(OctreeInserterTest, EveryInnerNodeIsTheMaximumOfItsChildren) {
  std::mt19937 random(5);
  OctreeInserter inserter({}, Bayes());
  SemanticOcTree tree(kResolutionM);
  for (int scan = 0; scan < 4; ++scan)
    inserter.Insert(RandomScan(random, 300), RandomPose(random), tree);
  std::size_t inner = 0;
  for (auto node = tree.begin_tree(); node != tree.end_tree(); ++node) {
    if (node.isLeaf()) {
      EXPECT_EQ(node.getDepth() == 16 || !tree.isNodeOccupied(*node), true);
      continue;
    }
    ++inner;
    EXPECT_EQ(node->getLogOdds(), node->getMaxChildLogOdds());
  }
  EXPECT_GT(inner, 1000u);
}

TEST(OctreeInserterTest, DoesNotDependOnTheOrderOfPoints) {
  std::mt19937 random(11);
  auto points = RandomScan(random, 500);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].labels =
        CompactLabels(Distribution(static_cast<LabelId>(1 + i % 7), 0.3f + 0.05f * (i % 11)));
    points[i].rgb = {static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(3 * i), 7};
  }
  SemanticOcTree a(1.5), b(1.5);  // coarse: many points in a voxel
  OctreeInserter inserter({}, Bayes());
  const std::vector<VoxelObservation> kept_a = inserter.Insert(points, Rigid3d::Identity(), a);
  std::shuffle(points.begin(), points.end(), random);
  const std::vector<VoxelObservation> kept_b = inserter.Insert(points, Rigid3d::Identity(), b);
  EXPECT_TRUE(a == b);
  ASSERT_EQ(kept_a.size(), kept_b.size());
  EXPECT_LT(kept_a.size(), points.size() / 2);
  for (std::size_t i = 0; i < kept_a.size(); ++i) EXPECT_EQ(kept_a[i].position, kept_b[i].position);
}

TEST(OctreeInserterTest, WhatItReturnsInsertsTheSame) {
  std::mt19937 random(13);
  SemanticOcTree first(kResolutionM), again(kResolutionM);
  OctreeInserter inserter({}, Bayes());
  for (int scan = 0; scan < 5; ++scan) {
    auto points = RandomScan(random, 2000);
    for (std::size_t i = 0; i < points.size(); i += 3) points[i].is_only_seen = true;
    const Rigid3d pose = RandomPose(random);
    const std::vector<VoxelObservation> kept = inserter.Insert(points, pose, first);
    inserter.Insert(kept, pose, again);
  }
  EXPECT_TRUE(first == again);
}

TEST(OctreeInserterTest, AHitWinsOverTheRaysOfTheSameScan) {
  SemanticOcTree tree(kResolutionM);
  OctreeInserter inserter({}, Bayes());
  inserter.Insert({Observation({0.0f, 0.0f, 1.05f}, kChair, 0.9f),
                   Observation({0.0f, 0.0f, 2.05f}, kChair, 0.9f)},
                  Rigid3d::Identity(), tree);
  EXPECT_FLOAT_EQ(tree.search(0.0, 0.0, 1.05)->getLogOdds(), tree.hit_log_odds());
  EXPECT_FLOAT_EQ(tree.search(0.0, 0.0, 1.55)->getLogOdds(), tree.miss_log_odds());
}

TEST(OctreeInserterTest, HitRangeStandsApartFromClearRange) {
  OctreeInserterOptions options;
  options.max_hit_range_m = 2.0;
  options.max_clear_range_m = 3.0;
  OctreeInserter inserter(options, Bayes());
  SemanticOcTree tree(kResolutionM);
  inserter.Insert({Observation({0.05f, 0.05f, 4.05f}, kChair, 0.9f)}, Rigid3d::Identity(), tree);
  EXPECT_EQ(tree.search(0.05, 0.05, 4.05), nullptr);
  EXPECT_EQ(tree.search(0.05, 0.05, 3.25), nullptr);
  ASSERT_NE(tree.search(0.05, 0.05, 2.75), nullptr);
  EXPECT_FALSE(tree.isNodeOccupied(tree.search(0.05, 0.05, 2.75)));

  options.max_hit_range_m = 3.0;
  options.max_clear_range_m = 2.0;
  OctreeInserter far_hits(options, Bayes());
  SemanticOcTree other(kResolutionM);
  far_hits.Insert({Observation({0.05f, 0.05f, 2.75f}, kChair, 0.9f)}, Rigid3d::Identity(), other);
  EXPECT_TRUE(other.isNodeOccupied(other.search(0.05, 0.05, 2.75)));
  EXPECT_EQ(other.search(0.05, 0.05, 2.35), nullptr);
  EXPECT_NE(other.search(0.05, 0.05, 1.75), nullptr);
}

TEST(OctreeInserterTest, TouchesNothingOutsideTheHeightLimits) {
  OctreeInserterOptions options;
  options.min_z_m = 0.0;
  options.max_z_m = 1.0;
  OctreeInserter inserter(options, Bayes());
  SemanticOcTree tree(kResolutionM);
  std::mt19937 random(17);
  inserter.Insert(RandomScan(random, 500), Rigid3d::Identity(), tree);
  ASSERT_GT(tree.getNumLeafNodes(), 100u);
  tree.expand();
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    EXPECT_GT(leaf.getZ(), 0.0);
    EXPECT_LT(leaf.getZ(), 1.1);
  }
}

TEST(OctreeInserterTest, ATransientPointClearsTheWayAndOccupiesNothing) {
  OctreeInserter inserter({}, Bayes());
  SemanticOcTree tree(kResolutionM);
  auto person = Observation({0.05f, 0.05f, 2.05f}, kPerson, 0.9f);
  person.is_only_seen = true;
  const std::vector<VoxelObservation> kept = inserter.Insert({person}, Rigid3d::Identity(), tree);
  EXPECT_EQ(tree.search(0.05, 0.05, 2.05), nullptr);
  EXPECT_FALSE(tree.isNodeOccupied(tree.search(0.05, 0.05, 1.05)));
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_TRUE(kept[0].is_only_seen);

  // Beside it in the same voxel something that stays: that is entered, under its own label.
  inserter.Insert({person, Observation({0.06f, 0.05f, 2.05f}, kChair, 0.6f)}, Rigid3d::Identity(),
                  tree);
  ASSERT_NE(tree.search(0.05, 0.05, 2.05), nullptr);
  EXPECT_EQ(tree.search(0.05, 0.05, 2.05)->labels().Unpacked().labels,
            (std::array<LabelId, 3>{kChair, 0, 0}));
}

TEST(OctreeInserterTest, AnEmptyScanChangesNothing) {
  OctreeInserter inserter({}, Bayes());
  SemanticOcTree tree(kResolutionM);
  EXPECT_TRUE(inserter.Insert({}, Rigid3d::Identity(), tree).empty());
  EXPECT_EQ(tree.size(), 0u);
  EXPECT_EQ(tree.getRoot(), nullptr);
}

TEST(OctreeInserterTest, AScanOutOfRangeAloneLeavesNoOccupiedStump) {
  OctreeInserterOptions options;
  options.max_clear_range_m = options.max_hit_range_m = 0.1;
  OctreeInserter inserter(options, Bayes());
  SemanticOcTree tree(1.0);  // the whole ray lies in the camera's voxel
  inserter.Insert({Observation({0.5f, 0.5f, 4.5f}, kChair, 0.9f)}, Rigid3d::Identity(), tree);
  EXPECT_EQ(tree.getRoot(), nullptr);
}

TEST(OctreeInserterTest, RefusesAPoseThatIsNoPlace) {
  OctreeInserter inserter({}, Bayes());
  SemanticOcTree tree(kResolutionM);
  Rigid3d pose = Rigid3d::Identity();
  pose.translation().x() = 1e6;
  const auto insert = [&] { inserter.Insert({Observation({0, 0, 1}, kChair, 0.5f)}, pose, tree); };
  EXPECT_NE(MessageOf<InputError>(insert).find("outside of the octree"), std::string::npos);
  pose.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(MessageOf<InputError>(insert), "");
  EXPECT_EQ(tree.getRoot(), nullptr);
}

TEST(OctreeInserterTest, LeavesOutPointsBeyondTheTree) {
  OctreeInserter inserter({}, Bayes());
  SemanticOcTree tree(0.01);  // reaches 327.68 m
  Rigid3d pose = Rigid3d::Identity();
  pose.translation().x() = 326.0;
  inserter.Insert({Observation({3.0f, 0.0f, 0.1f}, kChair, 0.5f),
                   Observation({1.0f, 0.0f, 0.1f}, kChair, 0.5f)},
                  pose, tree);
  EXPECT_TRUE(tree.isNodeOccupied(tree.search(327.0, 0.0, 0.1)));
}

TEST(OctreeInserterTest, ChecksItsOptions) {
  OctreeInserterOptions options;
  options.min_z_m = 2.0;
  options.max_z_m = 1.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { OctreeInserter(options, Bayes()); }),
            "min_z_m = 2, but must be below max_z_m = 1");
}

}  // namespace
}  // namespace semantic_slam
