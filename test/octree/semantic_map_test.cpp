#include "semantic_slam/octree/semantic_map.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "octree/octree_testing.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/octree/occupied_voxels.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

constexpr LabelId kChair = 5, kTable = 7, kPerson = 31;

SemanticPoint Point(const Eigen::Vector3f& position, LabelId label, float confidence = 0.8f) {
  return {position, {50, 60, 70}, {label, 0, 0}, {confidence, 0.0f, 0.0f}};
}

KeyframeGraph Graph(std::uint64_t revision, const std::vector<Rigid3d>& poses, int map_id = 1) {
  KeyframeGraph graph;
  graph.map_id = map_id;
  graph.revision = revision;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    graph.keyframes.emplace_back();
    graph.keyframes.back().id = static_cast<KeyframeId>(i);
    graph.keyframes.back().T_map_keyframe = poses[i];
    graph.keyframes.back().culled = i % 2 == 1;
  }
  return graph;
}

Rigid3d At(double x, double y = 0.0, double z = 0.0) {
  Rigid3d pose = Rigid3d::Identity();
  pose.translation() = Eigen::Vector3d(x, y, z);
  return pose;
}

TrackedImage Image(std::int64_t ns, KeyframeId keyframe,
                   const Rigid3d& T_keyframe_camera = Rigid3d::Identity()) {
  TrackedImage image;
  image.stamp.ns = ns;
  image.status = TrackingStatus::kTracking;
  image.map_id = 1;
  image.keyframe_id = keyframe;
  image.T_keyframe_camera = T_keyframe_camera;
  return image;
}

class SemanticMapperTest : public testing::Test {
 protected:
  SemanticMapperTest() : vocabulary_(SmallVocabulary()) {}

  SemanticMapper Mapper(const SemanticMapperOptions& options = {}) const {
    return {options, vocabulary_};
  }

  SemanticCloud Cloud(std::int64_t ns, std::vector<SemanticPoint> points) const {
    SemanticCloud cloud;
    cloud.stamp.ns = ns;
    cloud.vocabulary_hash = vocabulary_->hash();
    cloud.points = std::move(points);
    return cloud;
  }

  // A wall 2 m before the camera, of tables on the left and chairs on the right, with a point in
  // every voxel.
  SemanticCloud Wall(std::int64_t ns, std::uint32_t seed = 1) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> jitter(0.003f, 0.022f);
    std::vector<SemanticPoint> points;
    for (int i = -40; i < 40; ++i) {
      for (int j = -40; j < 40; ++j) {
        const Eigen::Vector3f p(0.025f * i + jitter(random), 0.025f * j + jitter(random), 2.02f);
        points.push_back(Point(p, i < 0 ? kTable : kChair));
      }
    }
    return Cloud(ns, std::move(points));
  }

  const std::shared_ptr<const LabelVocabulary> vocabulary_;
};

bool IsOccupied(const SemanticMapper& mapper, double x, double y, double z) {
  const SemanticNode* node = mapper.tree().search(x, y, z);
  return node != nullptr && mapper.tree().isNodeOccupied(node);
}

TEST_F(SemanticMapperTest, EntersACloudWhereItsKeyframeIs) {
  SemanticMapper mapper = Mapper();
  EXPECT_TRUE(mapper.tree().size() == 0);
  EXPECT_FALSE(mapper.FollowGraph(Graph(1, {At(10.0), At(20.0)})));
  EXPECT_TRUE(mapper.Insert(Wall(5), Image(5, 1, At(0.0, 0.0, 1.0))));
  EXPECT_TRUE(IsOccupied(mapper, 20.52, 0.02, 3.02));
  EXPECT_FALSE(IsOccupied(mapper, 20.52, 0.02, 2.02));
  EXPECT_EQ(mapper.tree().search(20.52, 0.02, 3.02)->labels().label(0), kChair);
  EXPECT_EQ(mapper.tree().search(19.52, 0.02, 3.02)->labels().label(0), kTable);
  EXPECT_EQ(mapper.stamp(), (Stamp{5}));
  EXPECT_EQ(mapper.map_id(), 1);
  EXPECT_EQ(mapper.counts().inserted, 1u);
}

TEST_F(SemanticMapperTest, DropsAndCountsWhatHasNoPlace) {
  SemanticMapper mapper = Mapper();
  EXPECT_FALSE(mapper.Insert(Wall(1), Image(1, 0)));  // no graph yet
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  EXPECT_FALSE(mapper.Insert(Wall(2), Image(2, 7)));
  TrackedImage other_map = Image(3, 0);
  other_map.map_id = 2;
  EXPECT_FALSE(mapper.Insert(Wall(3), other_map));
  TrackedImage lost = Image(4, 0);
  lost.status = TrackingStatus::kLost;
  EXPECT_FALSE(mapper.Insert(Wall(4), lost));
  EXPECT_EQ(mapper.counts().unknown_keyframe, 3u);
  EXPECT_EQ(mapper.counts().not_tracked, 1u);
  EXPECT_EQ(mapper.counts().inserted, 0u);
  EXPECT_EQ(mapper.tree().size(), 0u);
}

TEST_F(SemanticMapperTest, AnEmptyCloudIsNoError) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  EXPECT_TRUE(mapper.Insert(Cloud(1, {}), Image(1, 0)));
  EXPECT_EQ(mapper.tree().size(), 0u);
}

TEST_F(SemanticMapperTest, RefusesACloudThatIsNotSound) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  SemanticCloud cloud = Wall(1);
  EXPECT_NE(MessageOf<InputError>([&] { mapper.Insert(cloud, Image(2, 0)); }), "");
  cloud.points[3].confidences[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(MessageOf<InputError>([&] { mapper.Insert(cloud, Image(1, 0)); }), "");
  EXPECT_EQ(mapper.tree().size(), 0u);
}

TEST_F(SemanticMapperTest, SmallCorrectionsLeaveTheMapAlone) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0), At(1.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  const std::uint64_t version = mapper.version();
  EXPECT_FALSE(mapper.FollowGraph(Graph(2, {At(0.04), At(3.0)})));  // keyframe 1 has no cloud
  EXPECT_EQ(mapper.version(), version);
  EXPECT_EQ(mapper.revision(), 2u);
}

// What moved by a loop closure of 0.3 m is where it would have been entered with the right poses.
TEST_F(SemanticMapperTest, AfterALoopClosureTheMapIsAsIfThePosesHadAlwaysBeenRight) {
  SemanticMapper mapper = Mapper(), expected = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0), At(5.3)}));
  expected.FollowGraph(Graph(1, {At(0.0), At(5.0)}));
  for (int i = 0; i < 6; ++i) {
    for (SemanticMapper* each : {&mapper, &expected})
      each->Insert(Wall(i, i), Image(i, i % 2, At(0.01 * i)));
  }
  EXPECT_TRUE(mapper.FollowGraph(Graph(2, {At(0.0), At(5.0)})));
  EXPECT_EQ(mapper.counts().rebuilds, 1u);
  EXPECT_EQ(mapper.clouds().clouds().size(), 6u);
  // Each kept point is a real one, but of several in a voxel only one is kept, and where the voxels
  // lay otherwise a neighbour may be left without.
  std::size_t occupied = 0, missing = 0, wrong = 0;
  ForEachOccupiedVoxel(expected.tree(),
                       [&](const octomap::OcTreeKey& key, const SemanticNode& node) {
                         ++occupied;
                         const SemanticNode* ours = mapper.tree().search(key);
                         if (ours == nullptr || !mapper.tree().isNodeOccupied(ours)) {
                           ++missing;
                         } else {
                           wrong += ours->labels().label(0) != node.labels().label(0);
                         }
                       });
  ASSERT_GT(occupied, 3000u);
  EXPECT_LT(missing, occupied / 50);
  EXPECT_LT(wrong, occupied / 100);
  ForEachOccupiedLeaf(
      mapper.tree(), [](const Eigen::Vector3d& centre, double, const SemanticNode&) {
        EXPECT_NEAR(centre.z(), 2.025, 1e-6);  // coordinates are float: no voxel beside the wall
      });
}

TEST_F(SemanticMapperTest, RebuildsTheSameMapEveryTime) {
  SemanticMapper mapper = Mapper(), twin = Mapper();
  for (SemanticMapper* each : {&mapper, &twin}) {
    each->FollowGraph(Graph(1, {At(0.0), At(0.4)}));
    for (int i = 0; i < 4; ++i) each->Insert(Wall(i, i), Image(i, i % 2, At(0.01 * i)));
  }
  mapper.FollowGraph(Graph(2, {At(0.0), At(1.4)}));
  mapper.FollowGraph(Graph(3, {At(0.0), At(0.4)}));
  EXPECT_EQ(mapper.counts().rebuilds, 2u);
  twin.FollowGraph(Graph(2, {At(0.0), At(1.4)}));
  twin.FollowGraph(Graph(3, {At(0.0), At(0.4)}));
  EXPECT_TRUE(mapper.tree() == twin.tree());
}

TEST_F(SemanticMapperTest, CloudsThatComeDuringARebuildAreInTheNewMap) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0), At(5.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  EXPECT_FALSE(mapper.TakeOver(Graph(2, {At(0.0, 0.5), At(5.0)})));
  ASSERT_TRUE(mapper.NeedsRebuild());
  const auto rebuild = mapper.BeginRebuild();
  // The old map stays until the new one is there, and takes in what comes.
  EXPECT_TRUE(IsOccupied(mapper, 0.52, -0.52, 2.02));
  mapper.Insert(Wall(2), Image(2, 1));
  EXPECT_TRUE(IsOccupied(mapper, 5.52, 0.02, 2.02));
  rebuild->Run();
  EXPECT_TRUE(IsOccupied(mapper, 0.52, -0.52, 2.02));
  EXPECT_FALSE(mapper.FinishRebuild(*rebuild));  // there is one more cloud
  rebuild->Run();
  EXPECT_TRUE(mapper.FinishRebuild(*rebuild));
  EXPECT_EQ(mapper.counts().rebuilds, 1u);
  EXPECT_FALSE(IsOccupied(mapper, 0.52, -0.52, 2.02));
  EXPECT_TRUE(IsOccupied(mapper, 0.52, 1.02, 2.02));
  EXPECT_TRUE(IsOccupied(mapper, 5.52, 0.02, 2.02));
  EXPECT_FALSE(mapper.NeedsRebuild());
}

TEST_F(SemanticMapperTest, AResetThrowsARebuildAway) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  mapper.TakeOver(Graph(2, {At(1.0)}));
  const auto rebuild = mapper.BeginRebuild();
  mapper.Reset();
  rebuild->Run();
  EXPECT_TRUE(mapper.FinishRebuild(*rebuild));
  EXPECT_EQ(mapper.tree().size(), 0u);
  EXPECT_EQ(mapper.counts().rebuilds, 0u);
}

TEST_F(SemanticMapperTest, GoesOnFromALoadedMapAlsoWhenItIsRebuilt) {
  SemanticMapper earlier = Mapper(), mapper = Mapper();
  earlier.FollowGraph(Graph(1, {At(10.0)}));
  earlier.Insert(Wall(1), Image(1, 0));
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  mapper.Load(earlier.tree().Copy());
  EXPECT_TRUE(mapper.tree() == earlier.tree());
  mapper.Insert(Wall(2), Image(2, 0));
  ASSERT_TRUE(mapper.FollowGraph(Graph(2, {At(1.0)})));
  EXPECT_TRUE(IsOccupied(mapper, 10.52, 0.02, 2.02));
  EXPECT_TRUE(IsOccupied(mapper, 1.52, 0.02, 2.02));
  KeyframeGraph lost = Graph(3, {}, 2);
  lost.reason = RevisionReason::kLost;
  ASSERT_TRUE(mapper.FollowGraph(lost));
  EXPECT_EQ(mapper.tree().size(), 0u);
  EXPECT_FALSE(mapper.NeedsRebuild());
  mapper.Reset();
  EXPECT_EQ(mapper.tree().size(), 0u);
  EXPECT_NE(MessageOf<InputError>([&] { mapper.Load(std::make_unique<SemanticOcTree>(0.1)); }), "");
}

TEST_F(SemanticMapperTest, WhatWasClearedStaysSoUntilItIsSeenAgain) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0.3, -5.0, 0.0), Eigen::Vector3d(5.0, 5.0, 5.0));
  EXPECT_GT(mapper.Clear(box), 100u);
  EXPECT_FALSE(IsOccupied(mapper, 0.52, 0.02, 2.02));
  EXPECT_TRUE(IsOccupied(mapper, 0.12, 0.02, 2.02));
  ASSERT_TRUE(mapper.FollowGraph(Graph(2, {At(0.2)})));
  EXPECT_FALSE(IsOccupied(mapper, 0.52, 0.02, 2.02));
  for (int i = 2; i < 8; ++i) mapper.Insert(Wall(i), Image(i, 0));
  EXPECT_TRUE(IsOccupied(mapper, 0.52, 0.02, 2.02));
  ASSERT_TRUE(mapper.FollowGraph(Graph(3, {At(0.0)})));
  EXPECT_TRUE(IsOccupied(mapper, 0.52, 0.02, 2.02));
}

TEST_F(SemanticMapperTest, ATurnMovesTheSurroundingsToo) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  Rigid3d turned = At(0.0);
  turned.linear() = ExpSo3(Eigen::Vector3d(0.0, 0.02, 0.0));  // 6 cm at 3 m
  EXPECT_TRUE(mapper.FollowGraph(Graph(2, {turned})));
}

TEST_F(SemanticMapperTest, AKeyframeThatIsNoLongerListedTakesItsCloudsAlongAndBringsThemBack) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0), At(10.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  mapper.Insert(Wall(2), Image(2, 1));
  EXPECT_TRUE(mapper.FollowGraph(Graph(2, {At(0.0)})));
  EXPECT_TRUE(IsOccupied(mapper, 0.52, 0.02, 2.02));
  EXPECT_FALSE(IsOccupied(mapper, 10.52, 0.02, 2.02));
  EXPECT_EQ(mapper.CameraPath().size(), 1u);
  EXPECT_FALSE(mapper.FollowGraph(Graph(3, {At(0.0)})));
  EXPECT_TRUE(mapper.FollowGraph(Graph(4, {At(0.0), At(20.0)})));
  EXPECT_TRUE(IsOccupied(mapper, 20.52, 0.02, 2.02));
  EXPECT_EQ(mapper.counts().lost_keyframe, 0u);
}

TEST_F(SemanticMapperTest, AMapThatTrackingLostComesBackWhenItIsJoined) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(7, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  KeyframeGraph second = Graph(8, {At(0.0), At(0.0)}, 2);
  second.reason = RevisionReason::kLost;
  second.keyframes.erase(second.keyframes.begin());  // a new map, of keyframe 1
  EXPECT_TRUE(mapper.FollowGraph(second));
  EXPECT_EQ(mapper.map_id(), 2);
  EXPECT_EQ(mapper.tree().size(), 0u);
  TrackedImage image = Image(2, 1);
  image.map_id = 2;
  EXPECT_TRUE(mapper.Insert(Wall(2), image));
  EXPECT_TRUE(mapper.FollowGraph(Graph(9, {At(0.0), At(10.0)}, 2)));
  EXPECT_TRUE(IsOccupied(mapper, 0.52, 0.02, 2.02));
  EXPECT_TRUE(IsOccupied(mapper, 10.52, 0.02, 2.02));
}

TEST_F(SemanticMapperTest, AResetALoadedMapOrANewStartOfTrackingForgetsAll) {
  KeyframeGraph reset = Graph(8, {At(0.0)}, 2), loaded = reset,
                earlier_map = Graph(8, {At(0.0)}, 0);
  reset.reason = RevisionReason::kReset;
  loaded.reason = RevisionReason::kLoad;
  for (const KeyframeGraph& graph : {reset, loaded, earlier_map, Graph(6, {At(0.0)})}) {
    SemanticMapper mapper = Mapper();
    mapper.FollowGraph(Graph(7, {At(0.0)}));
    mapper.Insert(Wall(1), Image(1, 0));
    EXPECT_TRUE(mapper.FollowGraph(graph));
    EXPECT_EQ(mapper.tree().size(), 0u);
    EXPECT_TRUE(mapper.clouds().clouds().empty());
    EXPECT_EQ(mapper.map_id(), graph.map_id);
  }
}

TEST_F(SemanticMapperTest, TheCamerasPathFollowsTheGraph) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0), At(1.0)}));
  mapper.Insert(Wall(1), Image(1, 0, At(0.1)));
  mapper.Insert(Wall(2), Image(2, 1, At(0.2)));
  mapper.FollowGraph(Graph(2, {At(0.0), At(1.02)}));
  ASSERT_EQ(mapper.CameraPath().size(), 2u);
  EXPECT_TRUE(mapper.CameraPath()[0].isApprox(Eigen::Vector3d(0.1, 0.0, 0.0)));
  EXPECT_TRUE(mapper.CameraPath()[1].isApprox(Eigen::Vector3d(1.22, 0.0, 0.0)));
}

TEST_F(SemanticMapperTest, ResetForgetsTheMapButNotTheGraph) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  mapper.Reset();
  EXPECT_EQ(mapper.tree().size(), 0u);
  EXPECT_TRUE(mapper.Insert(Wall(2), Image(2, 0)));
}

TEST_F(SemanticMapperTest, RefusesAGraphWithAPoseThatIsNotFinite) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectOneLineWith(MessageOf<InputError>([&] { mapper.FollowGraph(Graph(2, {At(nan)})); }),
                    {"keyframe 0"});
  EXPECT_EQ(mapper.revision(), 1u);
  EXPECT_TRUE(IsOccupied(mapper, 0.52, 0.02, 2.02));
}

TEST_F(SemanticMapperTest, AKeyframeThatLeavesTheOctreeIsLost) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  mapper.Insert(Wall(1), Image(1, 0));
  EXPECT_TRUE(mapper.FollowGraph(Graph(2, {At(1e6)})));
  EXPECT_EQ(mapper.counts().lost_keyframe, 1u);
  EXPECT_EQ(mapper.tree().size(), 0u);
}

TEST_F(SemanticMapperTest, APersonIsNotEnteredAndIsClearedWhenSeenThrough) {
  SemanticMapper mapper = Mapper();
  mapper.FollowGraph(Graph(1, {At(0.0)}));
  const Eigen::Vector3f there(0.02f, 0.02f, 1.52f);
  // At first the network takes the person for a chair.
  mapper.Insert(Cloud(1, {Point(there, kChair)}), Image(1, 0));
  EXPECT_TRUE(IsOccupied(mapper, 0.02, 0.02, 1.52));
  for (int i = 2; i < 6; ++i) mapper.Insert(Cloud(i, {Point(there, kPerson)}), Image(i, 0));
  EXPECT_EQ(mapper.tree().search(0.02, 0.02, 1.52)->labels().label(0), kChair);
  // The person leaves.
  for (int i = 6; i < 10; ++i)
    mapper.Insert(Cloud(i, {Point({0.04f, 0.04f, 3.04f}, kTable)}), Image(i, 0));
  EXPECT_FALSE(IsOccupied(mapper, 0.02, 0.02, 1.52));
  EXPECT_TRUE(IsOccupied(mapper, 0.04, 0.04, 3.04));
}

TEST_F(SemanticMapperTest, StaysWithinItsBudgetAndStillCoversTheRun) {
  SemanticMapperOptions options;
  options.map.max_clouds_on_disk_mb = 1;
  SemanticMapper mapper = Mapper(options);
  std::vector<Rigid3d> poses;
  for (int i = 0; i < 80; ++i) poses.push_back(At(0.5 * i));
  mapper.FollowGraph(Graph(1, poses));
  for (int i = 0; i < 80; ++i) mapper.Insert(Wall(i, i), Image(i, i));
  EXPECT_GT(mapper.clouds().keeps_one_of(), 1u);
  EXPECT_LE(mapper.clouds().disk_bytes(), std::size_t{1} << 20);
  for (Rigid3d& pose : poses) pose.translation().y() += 0.3;
  ASSERT_TRUE(mapper.FollowGraph(Graph(2, poses)));
  for (double x = 0.0; x < 19.0; x += 0.5) {
    int occupied = 0;
    for (double y = -0.4; y < 1.0; y += 0.05)
      occupied += IsOccupied(mapper, x + 0.02, y + 0.02, 2.02);
    EXPECT_GT(occupied, 10) << x;
  }
}

TEST_F(SemanticMapperTest, ChecksItsOptions) {
  SemanticMapperOptions options;
  options.map.transient_classes = "person, unicorn";
  EXPECT_EQ(MessageOf<ConfigError>([&] { Mapper(options); }),
            "transient_classes: 'unicorn' is not in the vocabulary");
  options.map.transient_classes = "";
  options.map.resolution_m = 0.01;
  options.insertion.max_hit_range_m = 20.0;
  EXPECT_NE(MessageOf<ConfigError>([&] {
              Mapper(options);
            }).find("max_hit_range_m / resolution_m = 2000"),
            std::string::npos);
}

}  // namespace
}  // namespace semantic_slam
