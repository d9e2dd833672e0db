#include "semantic_slam/map/map.h"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

Rigid3d At(double x_m, double y_m, double z_m) {
  return Rigid3d(Eigen::Translation3d(x_m, y_m, z_m));
}

// Two frames of different content; the tests refer to features by number.
const std::shared_ptr<const FrameFeatures>& FrameA() {
  static const auto kFrame = SquaresFeatures(1);
  return kFrame;
}
const std::shared_ptr<const FrameFeatures>& FrameB() {
  static const auto kFrame = SquaresFeatures(2);
  return kFrame;
}

class MapTest : public testing::Test {
 protected:
  KeyframeId AddKeyframe(const Rigid3d& T_map_camera = Rigid3d::Identity()) {
    return map_.AddKeyframe(FrameA(), T_map_camera).id;
  }

  // A point that all the keyframes see as feature `feature`.
  PointId AddSharedPoint(const std::vector<KeyframeId>& keyframes, int feature) {
    const PointId id = map_.AddPoint({0.0, 0.0, 2.0}, keyframes.front(), feature).id;
    for (std::size_t i = 1; i < keyframes.size(); ++i) {
      map_.AddObservation(id, keyframes[i], feature);
    }
    return id;
  }

  void AddSharedPoints(const std::vector<KeyframeId>& keyframes, int first_feature, int count) {
    for (int i = 0; i < count; ++i) AddSharedPoint(keyframes, first_feature + i);
  }

  Map map_{SmallExtractor().scales()};
};

using MapPointTest = MapTest;

TEST_F(MapPointTest, IsSeenFromTheKeyframeThatMadeIt) {
  const KeyframeId keyframe = AddKeyframe(At(1.0, 0.0, 0.0));
  const MapPoint& point = map_.AddPoint({1.0, 0.0, 2.0}, keyframe, 7);
  EXPECT_EQ(map_.FindKeyframe(keyframe)->points[7], point.id);
  ASSERT_EQ(point.observations.size(), 1u);
  EXPECT_EQ(point.observations[0].keyframe, keyframe);
  EXPECT_EQ(point.observations[0].feature, 7);
  EXPECT_EQ(point.reference, keyframe);
  EXPECT_EQ(point.descriptor, FrameA()->descriptor(7));
  EXPECT_EQ(map_.point_count(), 1u);
}

TEST_F(MapPointTest, ItsDistancesAreThoseAtWhichItsPatchFitsThePyramid) {
  const std::vector<float>& scales = map_.scales();
  const auto& features = FrameA()->features();
  for (const int octave : {0, 2}) {
    const auto feature = std::find_if(features.begin(), features.end(),
                                      [&](const Feature& f) { return f.octave == octave; });
    ASSERT_NE(feature, features.end());
    const KeyframeId keyframe = AddKeyframe();
    const MapPoint& point =
        map_.AddPoint({0.0, 0.0, 2.0}, keyframe, static_cast<int>(feature - features.begin()));
    // From `scale` times as far it would be found on level 0.
    EXPECT_NEAR(point.max_distance_m, 2.0 * scales[octave], 1e-12);
    EXPECT_NEAR(point.min_distance_m, point.max_distance_m / scales.back(), 1e-12);
  }
}

TEST_F(MapPointTest, ItsDirectionIsTheMeanOfThoseToItsCameras) {
  const KeyframeId in_front = AddKeyframe(), beside = AddKeyframe(At(2.0, 0.0, 2.0));
  const PointId id = map_.AddPoint({0.0, 0.0, 2.0}, in_front, 0).id;
  EXPECT_TRUE(map_.FindPoint(id)->view_direction.isApprox(-Eigen::Vector3d::UnitZ()));
  map_.AddObservation(id, beside, 0);
  map_.UpdatePointGeometry(id);
  EXPECT_TRUE(
      map_.FindPoint(id)->view_direction.isApprox(Eigen::Vector3d(1.0, 0.0, -1.0).normalized()));
}

TEST_F(MapPointTest, ItsDescriptorIsTheMedian) {
  const std::vector<KeyframeId> keyframes{AddKeyframe(), AddKeyframe(), AddKeyframe()};
  const PointId id = map_.AddPoint({0.0, 0.0, 2.0}, keyframes[0], 5).id;
  map_.AddObservation(id, keyframes[1], 3);
  map_.AddObservation(id, keyframes[2], 3);
  map_.UpdatePointAppearance(id);
  EXPECT_EQ(map_.FindPoint(id)->descriptor, FrameA()->descriptor(3));  // two against one
}

TEST_F(MapPointTest, AKeyframeSeesAPointOnce) {
  const KeyframeId keyframe = AddKeyframe();
  const PointId id = map_.AddPoint({0.0, 0.0, 2.0}, keyframe, 0).id;
  map_.AddObservation(id, keyframe, 1);
  EXPECT_EQ(map_.FindPoint(id)->observations.size(), 1u);
  EXPECT_EQ(map_.FindKeyframe(keyframe)->points[1], kNoPoint);
}

TEST_F(MapPointTest, GoesWithItsLastButOneObservation) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe(), c = AddKeyframe();
  const PointId id = AddSharedPoint({a, b, c}, 4);
  map_.RemoveObservation(id, a);
  ASSERT_NE(map_.FindPoint(id), nullptr);
  EXPECT_EQ(map_.FindPoint(id)->reference, b);  // no longer the keyframe that made it
  map_.RemoveObservation(id, c);
  EXPECT_EQ(map_.FindPoint(id), nullptr);
  for (const KeyframeId keyframe : {a, b, c}) {
    EXPECT_EQ(map_.FindKeyframe(keyframe)->points[4], kNoPoint);
  }
  EXPECT_EQ(map_.point_count(), 0u);
  map_.RemoveObservation(id, b);  // of a point that is gone: nothing happens
}

TEST_F(MapPointTest, MergingJoinsTheObservations) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe(), both = AddKeyframe();
  const PointId from = AddSharedPoint({a, both}, 1), to = AddSharedPoint({b, both}, 2);
  map_.FindPoint(from)->visible = 10;
  map_.FindPoint(from)->found = 5;
  map_.MergePoints(from, to);
  EXPECT_EQ(map_.FindPoint(from), nullptr);
  const MapPoint& merged = *map_.FindPoint(to);
  ASSERT_EQ(merged.observations.size(), 3u);
  EXPECT_EQ(map_.FindKeyframe(a)->points[1], to);
  EXPECT_EQ(map_.FindKeyframe(b)->points[2], to);
  EXPECT_EQ(map_.FindKeyframe(both)->points[2], to);  // `to`'s own feature stays
  EXPECT_EQ(map_.FindKeyframe(both)->points[1], kNoPoint);
  EXPECT_EQ(merged.visible, 11);
  EXPECT_EQ(merged.found, 6);
  EXPECT_EQ(map_.point_count(), 1u);
}

TEST_F(MapPointTest, ResolveFollowsMergesToTheEnd) {
  const KeyframeId a = AddKeyframe(), b = AddKeyframe();
  std::vector<PointId> ids;
  for (int i = 0; i < 3; ++i) ids.push_back(AddSharedPoint({a, b}, i));
  map_.MergePoints(ids[0], ids[1]);
  map_.MergePoints(ids[1], ids[2]);
  for (const PointId id : ids) EXPECT_EQ(map_.Resolve(id), ids[2]);
  map_.ErasePoint(ids[2]);
  for (const PointId id : ids) EXPECT_EQ(map_.Resolve(id), kNoPoint);
  EXPECT_EQ(map_.Resolve(kNoPoint), kNoPoint);
  EXPECT_EQ(map_.Resolve(12345), kNoPoint);
}

TEST_F(MapPointTest, MergingAPointWithItselfIsNothing) {
  const PointId id = AddSharedPoint({AddKeyframe(), AddKeyframe()}, 0);
  map_.MergePoints(id, id);
  EXPECT_EQ(map_.Resolve(id), id);
  EXPECT_EQ(map_.FindPoint(id)->observations.size(), 2u);
}

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
    return last_point_ < 0 ? kNoPoint : map_.Resolve(Below(static_cast<int>(last_point_) + 1));
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
    EXPECT_GT(id, last_point_) << "an id was used again";
    last_point_ = id;
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
  PointId last_point_ = kNoPoint;
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

// Two maps: one dormant, of keyframes 0 and 1, and the present one, of 2 and 3.
class TwoMapsTest : public MapTest {
 protected:
  TwoMapsTest() {
    AddPair();
    map_.BeginNew(1000);
    AddPair();
  }

  void AddPair() {
    const KeyframeId a = AddKeyframe(), b = AddKeyframe(At(1.0, 0.0, 0.0));
    points_.push_back(AddSharedPoint({a, b}, 0));
    map_.UpdateCovisibility(a);
    map_.UpdateCovisibility(b);
  }

  std::vector<PointId> points_;
};

TEST_F(TwoMapsTest, ThePresentOneIsShownAndTheDormantOneKept) {
  EXPECT_EQ(map_.map_id(), 1);
  EXPECT_EQ(map_.dormant_keyframes(), 2u);
  const KeyframeGraph graph = map_.Graph();
  EXPECT_EQ(graph.map_id, 1);
  EXPECT_EQ(graph.reason, RevisionReason::kLost);
  ASSERT_EQ(graph.keyframes.size(), 2u);
  EXPECT_EQ(graph.keyframes[0].id, 2);
  EXPECT_EQ(graph.keyframes[0].parent_id, kNoKeyframe);  // it has nothing to do with keyframe 1
  EXPECT_EQ(graph.keyframes[1].parent_id, 2);
  EXPECT_EQ(map_.ColouredPoints().size(), 1u);
  EXPECT_NE(map_.FindPoint(points_[0]), nullptr);
  EXPECT_FALSE(map_.IsPresent(*map_.FindKeyframe(1)));
}

TEST_F(TwoMapsTest, JoinedTheyAreOneMapInTheDormantOnesFrame) {
  const Rigid3d T = At(0.0, 5.0, 0.0) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  map_.JoinTo(1, T);
  EXPECT_EQ(map_.dormant_keyframes(), 0u);
  const KeyframeGraph graph = map_.Graph();
  EXPECT_EQ(graph.map_id, 1);
  EXPECT_EQ(graph.reason, RevisionReason::kMerge);
  ASSERT_TRUE(graph.merge);
  EXPECT_EQ(graph.merge->old_map_id, 0);
  EXPECT_EQ(graph.merge->new_map_id, 1);
  EXPECT_TRUE(graph.merge->T_new_old.isApprox(Rigid3d::Identity()));
  ASSERT_EQ(graph.keyframes.size(), 4u);
  EXPECT_TRUE(graph.keyframes[1].T_map_keyframe.isApprox(At(1.0, 0.0, 0.0)));
  EXPECT_EQ(graph.keyframes[2].parent_id, 1);
  EXPECT_TRUE(graph.keyframes[2].T_map_keyframe.isApprox(T));
  EXPECT_TRUE(graph.keyframes[3].T_map_keyframe.isApprox(T * At(1.0, 0.0, 0.0)));
  EXPECT_TRUE(map_.FindPoint(points_[1])->position.isApprox(T * Eigen::Vector3d(0.0, 0.0, 2.0)));
  EXPECT_TRUE(map_.FindPoint(points_[0])->position.isApprox(Eigen::Vector3d(0.0, 0.0, 2.0)));
  EXPECT_EQ(map_.ColouredPoints().size(), 2u);
  map_.BumpRevision(RevisionReason::kLocalBa);
  EXPECT_FALSE(map_.Graph().merge);
}

TEST_F(TwoMapsTest, AThirdMapMayBeJoinedToAnOlderOneThanTheSecond) {
  map_.BeginNew(1000);
  AddPair();
  map_.JoinTo(3, Rigid3d::Identity());
  map_.JoinTo(0, At(0.0, 1.0, 0.0));
  const KeyframeGraph graph = map_.Graph();
  EXPECT_EQ(graph.map_id, 2);
  ASSERT_EQ(graph.keyframes.size(), 6u);
  EXPECT_EQ(graph.keyframes[2].parent_id, 0);
  EXPECT_EQ(graph.keyframes[4].parent_id, 3);
}

TEST_F(TwoMapsTest, TheOldestAreForgottenWhereThereAreTooMany) {
  map_.BeginNew(2);
  EXPECT_EQ(map_.dormant_keyframes(), 2u);
  EXPECT_EQ(map_.FindKeyframe(0), nullptr);
  EXPECT_EQ(map_.FindPoint(points_[0]), nullptr);
  EXPECT_NE(map_.FindKeyframe(2), nullptr);
  map_.BeginNew(0);
  EXPECT_TRUE(map_.keyframes().empty());
  EXPECT_EQ(map_.point_count(), 0u);
}

TEST_F(TwoMapsTest, ClearingForgetsAll) {
  map_.Clear();
  EXPECT_EQ(map_.map_id(), 2);
  EXPECT_TRUE(map_.keyframes().empty());
}

}  // namespace
}  // namespace semantic_slam
