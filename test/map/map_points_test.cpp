// What Map does with points: src/semantic_slam/map/map_points.cpp.

#include "map/map_fixture.h"

namespace semantic_slam {
namespace {

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

}  // namespace
}  // namespace semantic_slam
