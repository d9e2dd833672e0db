#include "semantic_slam/map/map.h"

#include <algorithm>
#include <random>
#include <set>

#include "map/map_fixture.h"

namespace semantic_slam {
namespace {

TEST_F(MapTest, CovisibilityCountsSharedPointsBothWays) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe(), c = AddKeyframe();
  AddSharedPoints({a, b}, 0, 4);
  AddSharedPoints({a, b, c}, 4, 3);
  map_.UpdateCovisibility(b);
  map_.UpdateCovisibility(c);
  EXPECT_EQ(map_.FindKeyframe(a)->covisible, (std::map<KeyframeId, int>{{b, 7}, {c, 3}}));
  EXPECT_EQ(map_.FindKeyframe(b)->covisible, (std::map<KeyframeId, int>{{a, 7}, {c, 3}}));
  EXPECT_EQ(map_.FindKeyframe(c)->covisible, (std::map<KeyframeId, int>{{a, 3}, {b, 3}}));
  EXPECT_EQ(map_.BestCovisible(a, 10), (std::vector<KeyframeId>{b, c}));
  EXPECT_EQ(map_.BestCovisible(a, 1), (std::vector<KeyframeId>{b}));
  EXPECT_EQ(map_.BestCovisible(a, 10, 4), (std::vector<KeyframeId>{b}));
  EXPECT_EQ(map_.BestCovisible(c, 10), (std::vector<KeyframeId>{a, b}));  // equal: the older first
  EXPECT_EQ(map_.CountPoints(a, 1), 7);
  EXPECT_EQ(map_.CountPoints(a, 3), 3);
}

TEST_F(MapTest, CovisibilityForgetsWhatIsNoLongerShared) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe();
  AddSharedPoint({a, b}, 0);
  map_.UpdateCovisibility(b);
  map_.ErasePoint(map_.FindKeyframe(a)->points[0]);
  map_.UpdateCovisibility(b);
  EXPECT_TRUE(map_.FindKeyframe(a)->covisible.empty());
  EXPECT_TRUE(map_.FindKeyframe(b)->covisible.empty());
}

TEST_F(MapTest, TheParentIsTheOlderKeyframeThatSharesMost) {
  const KeyframeId first = AddKeyframe(), second = AddKeyframe(), third = AddKeyframe();
  map_.UpdateCovisibility(first);
  EXPECT_EQ(map_.FindKeyframe(first)->parent, kNoKeyframe);
  AddSharedPoints({first, second, third}, 0, 2);
  AddSharedPoints({first, third}, 2, 3);
  map_.UpdateCovisibility(second);
  map_.UpdateCovisibility(third);
  EXPECT_EQ(map_.FindKeyframe(second)->parent, first);
  EXPECT_EQ(map_.FindKeyframe(third)->parent, first);
  AddSharedPoints({second, third}, 5, 20);
  map_.UpdateCovisibility(third);
  EXPECT_EQ(map_.FindKeyframe(third)->parent, first) << "a parent is for life";
}

TEST_F(MapTest, AKeyframeThatSharesNothingHangsOnTheOneBefore) {
  for (int i = 0; i < 3; ++i) map_.UpdateCovisibility(AddKeyframe());
  EXPECT_EQ(map_.FindKeyframe(1)->parent, 0);
  EXPECT_EQ(map_.FindKeyframe(2)->parent, 1);
}

TEST_F(MapTest, ACulledKeyframeStaysInTheGraphAndFollowsItsParent) {
  for (int i = 0; i < 4; ++i) map_.UpdateCovisibility(AddKeyframe(At(i, 0.0, 0.0)));  // a chain
  map_.CullKeyframe(2);
  map_.CullKeyframe(1);  // the parent of the one culled before
  EXPECT_EQ(map_.FindKeyframe(2), nullptr);
  EXPECT_EQ(map_.FindKeyframe(3)->parent, 0);
  EXPECT_TRUE(map_.KeyframePose(1).isApprox(At(1.0, 0.0, 0.0)));
  EXPECT_TRUE(map_.KeyframePose(2).isApprox(At(2.0, 0.0, 0.0)));

  map_.FindKeyframe(0)->T_map_camera = At(0.0, 5.0, 0.0);
  EXPECT_TRUE(map_.KeyframePose(2).isApprox(At(2.0, 5.0, 0.0)));
  EXPECT_TRUE(map_.KeyframePose(3).isApprox(At(3.0, 0.0, 0.0)));  // alive: has a pose of its own

  const KeyframeGraph graph = map_.Graph();
  ASSERT_EQ(graph.keyframes.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(graph.keyframes[i].id, i);
    EXPECT_EQ(graph.keyframes[i].stamp, FrameA()->stamp());
    EXPECT_EQ(graph.keyframes[i].culled, i == 1 || i == 2);
    EXPECT_EQ(graph.keyframes[i].parent_id, i == 0 ? kNoKeyframe : 0);
  }
  EXPECT_TRUE(graph.keyframes[2].T_parent_keyframe.isApprox(At(2.0, 0.0, 0.0)));
  EXPECT_TRUE(graph.keyframes[3].T_parent_keyframe.isApprox(At(3.0, -5.0, 0.0)));
}

TEST_F(MapTest, ACulledKeyframeTakesItsObservationsAlong) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe(), c = AddKeyframe();
  const PointId of_three = AddSharedPoint({a, b, c}, 0), of_two = AddSharedPoint({a, b}, 1);
  for (const KeyframeId keyframe : {a, b, c}) map_.UpdateCovisibility(keyframe);
  map_.CullKeyframe(b);
  EXPECT_EQ(map_.FindPoint(of_three)->observations.size(), 2u);
  EXPECT_EQ(map_.FindPoint(of_two), nullptr);
  EXPECT_EQ(map_.FindKeyframe(a)->covisible, (std::map<KeyframeId, int>{{c, 1}}));
}

TEST_F(MapTest, LoopsGoWithTheirKeyframes) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe(), c = AddKeyframe();
  AddSharedPoint({a, b, c}, 0);
  for (const KeyframeId keyframe : {a, b, c}) map_.UpdateCovisibility(keyframe);
  map_.AddLoopEdge({a, b, Rigid3d::Identity()});
  map_.AddLoopEdge({a, c, Rigid3d::Identity()});
  map_.CullKeyframe(b);
  ASSERT_EQ(map_.loop_edges().size(), 1u);
  EXPECT_EQ(map_.loop_edges()[0].b, c);
}

TEST_F(MapTest, ClearingStartsANewMapWithNewIds) {
  const KeyframeId keyframe = AddKeyframe();
  map_.UpdateCovisibility(keyframe);
  const PointId point = AddSharedPoint({keyframe, AddKeyframe()}, 0);
  map_.UpdateCovisibility(1);
  map_.CullKeyframe(1);
  const std::uint64_t revision = map_.revision();
  map_.Clear();
  EXPECT_EQ(map_.map_id(), 1);
  EXPECT_GT(map_.revision(), revision);
  EXPECT_EQ(map_.Graph().reason, RevisionReason::kReset);
  EXPECT_EQ(map_.Graph().map_id, 1);
  EXPECT_TRUE(map_.Graph().keyframes.empty());
  EXPECT_EQ(map_.point_count(), 0u);
  EXPECT_TRUE(map_.ColouredPoints().empty());
  EXPECT_EQ(map_.FindPoint(point), nullptr);
  const KeyframeId next = AddKeyframe();
  EXPECT_EQ(next, 2);
  map_.UpdateCovisibility(next);
  EXPECT_EQ(map_.FindKeyframe(next)->parent, kNoKeyframe);
  EXPECT_GT(map_.AddPoint({0.0, 0.0, 2.0}, next, 0).id, point);
}

TEST_F(MapTest, UnknownIdsAreNotThere) {
  EXPECT_EQ(map_.FindKeyframe(0), nullptr);
  EXPECT_EQ(map_.FindKeyframe(kNoKeyframe), nullptr);
  EXPECT_EQ(map_.FindPoint(0), nullptr);
  EXPECT_EQ(map_.FindPoint(kNoPoint), nullptr);
}

// Does to a map what tracking and local mapping do, in an order that nobody would think of.
class RandomMapEdits {
 public:
  explicit RandomMapEdits(std::uint32_t seed) : random_(seed) {}

  void EditOnce() {
    using Edit = void (RandomMapEdits::*)();
    static constexpr Edit kEdits[] = {
        // the likely ones more than once
        &RandomMapEdits::AddKeyframe,    &RandomMapEdits::AddPoint,
        &RandomMapEdits::AddPoint,       &RandomMapEdits::AddPoint,
        &RandomMapEdits::AddObservation, &RandomMapEdits::AddObservation,
        &RandomMapEdits::MergePoints,    &RandomMapEdits::RemoveObservation,
        &RandomMapEdits::ErasePoint,     &RandomMapEdits::CullKeyframe};
    (this->*kEdits[Below(10)])();
  }

  Map& map() { return map_; }
  KeyframeId last_keyframe() const { return last_keyframe_; }

 private:
  int Below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }

  Keyframe* AnyKeyframe() {
    if (map_.keyframes().empty()) return nullptr;
    auto it = map_.keyframes().begin();
    std::advance(it, Below(static_cast<int>(map_.keyframes().size())));
    return it->second.get();
  }

  // A point that lives, or kNoPoint.
  PointId AnyPoint() {
    return made_.empty() ? kNoPoint : map_.Resolve(made_[Below(static_cast<int>(made_.size()))]);
  }

  void AddKeyframe() {
    const auto& frame = Below(2) == 0 ? FrameA() : FrameB();
    const Rigid3d T = Nudged(Rigid3d::Identity(), 1.0, 0.5, random_());
    const KeyframeId id = map_.AddKeyframe(frame, T).id;
    EXPECT_GT(id, last_keyframe_) << "an id was used again";
    last_keyframe_ = id;
    for (int i = 0; i < 30; ++i) {
      const PointId point = AnyPoint();
      if (point != kNoPoint && map_.FindKeyframe(id)->points[i] == kNoPoint) {
        map_.AddObservation(point, id, i);
      }
    }
    map_.UpdateCovisibility(id);
  }

  void AddPoint() {
    Keyframe* keyframe = AnyKeyframe();
    const int feature = Below(100);
    if (keyframe == nullptr || keyframe->points[feature] != kNoPoint) return;
    const PointId id = map_.AddPoint({0.1 * feature, 0.0, 3.0}, keyframe->id, feature).id;
    if (!made_.empty()) {
      EXPECT_GT(id, made_.back()) << "an id was used again";
    }
    made_.push_back(id);
  }

  void AddObservation() {
    Keyframe* keyframe = AnyKeyframe();
    const PointId point = AnyPoint();
    const int feature = Below(100);
    if (keyframe == nullptr || point == kNoPoint || keyframe->points[feature] != kNoPoint) return;
    map_.AddObservation(point, keyframe->id, feature);
  }

  void RemoveObservation() {
    Keyframe* keyframe = AnyKeyframe();
    const PointId point = AnyPoint();
    if (keyframe != nullptr && point != kNoPoint) map_.RemoveObservation(point, keyframe->id);
  }

  void MergePoints() {
    const PointId from = AnyPoint(), to = AnyPoint();
    if (from != kNoPoint && to != kNoPoint) map_.MergePoints(from, to);
  }

  void ErasePoint() { map_.ErasePoint(AnyPoint()); }

  void CullKeyframe() {
    Keyframe* keyframe = AnyKeyframe();
    if (keyframe == nullptr || keyframe->parent == kNoKeyframe || Below(3) != 0) return;
    const KeyframeGraph before = map_.Graph();
    map_.CullKeyframe(keyframe->id);
    for (const KeyframeNode& node : before.keyframes) {  // culling moves nothing
      EXPECT_TRUE(map_.KeyframePose(node.id).isApprox(node.T_map_keyframe, 1e-9)) << node.id;
    }
  }

  std::mt19937 random_;
  Map map_{SmallExtractor().scales()};
  KeyframeId last_keyframe_ = kNoKeyframe;
  std::vector<PointId> made_;  // all points, also those that are gone
};

void ExpectObservationsMirrored(const Map& map) {
  std::set<PointId> alive;
  std::size_t seen_by_keyframes = 0, seen_by_points = 0;
  for (const auto& [id, keyframe] : map.keyframes()) {
    for (std::size_t i = 0; i < keyframe->points.size(); ++i) {
      if (keyframe->points[i] == kNoPoint) continue;
      ++seen_by_keyframes;
      const MapPoint* point = map.FindPoint(keyframe->points[i]);
      ASSERT_NE(point, nullptr);
      const auto& all = point->observations;
      EXPECT_EQ(std::count_if(all.begin(), all.end(),
                              [&, k = id](const Observation& o) {
                                return o.keyframe == k && o.feature == static_cast<int>(i);
                              }),
                1);
      if (!alive.insert(point->id).second) continue;
      seen_by_points += all.size();
      EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.keyframe < b.keyframe;
      }));
      EXPECT_NE(map.FindKeyframe(point->reference), nullptr);
    }
  }
  EXPECT_EQ(seen_by_keyframes, seen_by_points);
  EXPECT_EQ(alive.size(), map.point_count());  // every point is seen by somebody
  EXPECT_EQ(map.ColouredPoints().size(), map.point_count());
}

void ExpectCovisibilitySymmetric(const Map& map) {
  for (const auto& [id, keyframe] : map.keyframes()) {
    for (const auto& [other, shared] : keyframe->covisible) {
      ASSERT_NE(map.FindKeyframe(other), nullptr);
      EXPECT_EQ(map.FindKeyframe(other)->covisible.at(id), shared);
    }
  }
}

void ExpectGraphIsATreeOfAllKeyframes(const Map& map, KeyframeId last_keyframe) {
  const KeyframeGraph graph = map.Graph();
  ASSERT_EQ(static_cast<KeyframeId>(graph.keyframes.size()), last_keyframe + 1);
  for (const KeyframeNode& node : graph.keyframes) {
    EXPECT_EQ(node.id, &node - graph.keyframes.data());
    EXPECT_EQ(node.culled, map.FindKeyframe(node.id) == nullptr);
    EXPECT_TRUE(node.T_map_keyframe.isApprox(map.KeyframePose(node.id), 1e-9));
    if (node.id == 0) {
      EXPECT_EQ(node.parent_id, kNoKeyframe);
      continue;
    }
    // Older than its child, so there is no cycle and every walk ends at keyframe 0.
    ASSERT_GE(node.parent_id, 0);
    EXPECT_LT(node.parent_id, node.id);
    EXPECT_NE(map.FindKeyframe(node.parent_id), nullptr);
    EXPECT_TRUE((map.KeyframePose(node.parent_id) * node.T_parent_keyframe)
                    .isApprox(node.T_map_keyframe, 1e-9));
  }
}

TEST(MapInvariantsTest, HoldAfterAnySequenceOfEdits) {
  for (const std::uint32_t seed : {1u, 2u, 3u}) {
    RandomMapEdits edits(seed);
    for (int i = 0; i < 400; ++i) {
      edits.EditOnce();
      ExpectObservationsMirrored(edits.map());
      ExpectCovisibilitySymmetric(edits.map());
      ExpectGraphIsATreeOfAllKeyframes(edits.map(), edits.last_keyframe());
      ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed << ", edit " << i;
    }
    EXPECT_GT(edits.last_keyframe(), 20);
    EXPECT_GT(edits.map().point_count(), 20u);
  }
}

}  // namespace
}  // namespace semantic_slam
