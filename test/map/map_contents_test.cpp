#include "semantic_slam/map/map_contents.h"

#include <gtest/gtest.h>

#include "map/small_maps.h"

namespace semantic_slam {
namespace {

class MapContentsTest : public testing::Test {
 protected:
  // What is left when the map's own contents are loaded into another.
  Map& Reload() {
    loaded_.Load(maps_.map.Contents());
    return loaded_;
  }

  SmallMaps maps_;
  Map loaded_{SmallExtractor().scales()};
};

void ExpectSameGraph(const KeyframeGraph& a, const KeyframeGraph& b, KeyframeId shift = 0) {
  ASSERT_EQ(a.keyframes.size(), b.keyframes.size());
  for (std::size_t i = 0; i < a.keyframes.size(); ++i) {
    const KeyframeNode &x = a.keyframes[i], &y = b.keyframes[i];
    EXPECT_EQ(x.id + shift, y.id);
    EXPECT_EQ(x.stamp, y.stamp);
    EXPECT_EQ(x.parent_id == kNoKeyframe ? kNoKeyframe : x.parent_id + shift, y.parent_id);
    EXPECT_EQ(x.culled, y.culled);
    EXPECT_EQ(x.T_map_keyframe.matrix(), y.T_map_keyframe.matrix());
    EXPECT_EQ(x.T_parent_keyframe.matrix(), y.T_parent_keyframe.matrix());
  }
}

TEST_F(MapContentsTest, TheGraphComesBack) {
  const KeyframeGraph before = maps_.map.Graph(), after = Reload().Graph();
  ASSERT_EQ(before.keyframes.size(), 4u);
  EXPECT_TRUE(before.keyframes[1].culled);
  ExpectSameGraph(before, after);
  EXPECT_EQ(after.reason, RevisionReason::kLoad);
  EXPECT_EQ(after.revision, 1u);
  EXPECT_EQ(loaded_.dormant_keyframes(), 4u);
}

TEST_F(MapContentsTest, KeyframesComeBackWithWhatTheyShareAndShow) {
  const Map& loaded = Reload();
  ASSERT_EQ(loaded.keyframes().size(), maps_.map.keyframes().size());
  for (const auto& [id, before] : maps_.map.keyframes()) {
    SCOPED_TRACE(id);
    const Keyframe* after = loaded.FindKeyframe(id);
    ASSERT_NE(after, nullptr);
    EXPECT_EQ(after->features, before->features);
    EXPECT_EQ(after->parent, before->parent);
    EXPECT_EQ(after->is_joint, before->is_joint);
    EXPECT_EQ(after->is_joint, id == 2);
    EXPECT_EQ(after->covisible, before->covisible);
    EXPECT_FALSE(after->covisible.empty());
    EXPECT_EQ(loaded.IsPresent(*after), maps_.map.IsPresent(*before));
    for (std::size_t i = 0; i < before->points.size(); ++i) {
      const MapPoint* was = maps_.map.FindPoint(before->points[i]);
      const MapPoint* is = loaded.FindPoint(after->points[i]);
      ASSERT_EQ(was == nullptr, is == nullptr) << i;
      if (was != nullptr) {
        EXPECT_EQ(was->position, is->position) << i;
      }
    }
  }
}

TEST_F(MapContentsTest, PointsComeBackWithWhoSeesThem) {
  maps_.map.FindPoint(maps_.map.FindKeyframe(6)->points[91])->visible = 17;
  const Map& loaded = Reload();
  std::vector<MapPoint> before, after;
  maps_.map.ForEachPoint([&](const MapPoint& point) { before.push_back(point); });
  loaded.ForEachPoint([&](const MapPoint& point) { after.push_back(point); });
  ASSERT_EQ(before.size(), after.size());
  EXPECT_EQ(loaded.point_count(), before.size());
  const MapContents contents = maps_.map.Contents();
  for (std::size_t i = 0; i < before.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(contents.points[i].id, static_cast<PointId>(i)) << "without gaps";
    EXPECT_EQ(after[i].position, before[i].position);
    EXPECT_EQ(after[i].view_direction, before[i].view_direction);
    EXPECT_EQ(after[i].min_distance_m, before[i].min_distance_m);
    EXPECT_EQ(after[i].max_distance_m, before[i].max_distance_m);
    EXPECT_EQ(after[i].descriptor, before[i].descriptor);
    EXPECT_EQ(after[i].rgb, before[i].rgb);
    EXPECT_EQ(after[i].reference, before[i].reference);
    EXPECT_EQ(after[i].visible, before[i].visible);
    EXPECT_EQ(after[i].found, before[i].found);
    ASSERT_EQ(after[i].observations.size(), before[i].observations.size());
    for (std::size_t k = 0; k < before[i].observations.size(); ++k) {
      EXPECT_EQ(after[i].observations[k].keyframe, before[i].observations[k].keyframe);
      EXPECT_EQ(after[i].observations[k].feature, before[i].observations[k].feature);
    }
  }
}

TEST_F(MapContentsTest, LoopsComeBackWhereBothEndsAreStillThere) {
  const Map& loaded = Reload();
  ASSERT_EQ(loaded.loop_edges().size(), 1u);
  EXPECT_EQ(loaded.loop_edges()[0].a, 4);
  EXPECT_EQ(loaded.loop_edges()[0].b, 7);
  EXPECT_EQ(loaded.loop_edges()[0].T_a_b.matrix(), ShiftedBy(0.3).matrix());
}

TEST_F(MapContentsTest, IdsComeAfterAllThatWereUsedBefore) {
  const KeyframeId own = loaded_.AddKeyframe(SquaresFeatures(1), Rigid3d::Identity()).id;
  const PointId own_point = loaded_.AddPoint({0.0, 0.0, 2.0}, own, 0).id;
  const std::uint64_t revision = loaded_.revision();
  Reload();
  EXPECT_EQ(loaded_.FindKeyframe(own), nullptr);
  EXPECT_EQ(loaded_.FindPoint(own_point), nullptr);
  EXPECT_EQ(loaded_.map_id(), 2) << "the dormant map has number 1";
  EXPECT_GT(loaded_.revision(), revision);
  const KeyframeId shift = own + 1;
  ExpectSameGraph(maps_.map.Graph(), loaded_.Graph(), shift);
  EXPECT_EQ(loaded_.loop_edges()[0].b, 7 + shift);
  const Keyframe& joint = *loaded_.FindKeyframe(2 + shift);
  EXPECT_EQ(joint.parent, 1 + shift);
  loaded_.ForEachPoint([&](const MapPoint& point) {
    EXPECT_GT(point.id, own_point);
    EXPECT_NE(loaded_.FindKeyframe(point.reference), nullptr);
    for (const Observation& o : point.observations) {
      EXPECT_EQ(loaded_.FindKeyframe(o.keyframe)->points[o.feature], point.id);
    }
  });
  // And those to come after all of the file's, also after the culled ones.
  EXPECT_EQ(loaded_.AddKeyframe(SquaresFeatures(1), Rigid3d::Identity()).id,
            SmallMaps::kNext + shift);
  const KeyframeId next = SmallMaps::kNext + shift + 1;
  Reload();
  EXPECT_EQ(loaded_.keyframes().begin()->first, next);
  EXPECT_EQ(loaded_.map_id(), 4);
}

TEST_F(MapContentsTest, KeptAndLoadedAgainAndAgainIdsGrowByTheMapsOwn) {
  const KeyframeId first = maps_.map.Contents().keyframes.front().id;
  Reload();
  for (int i = 0; i < 100; ++i) loaded_.Load(MapContents(loaded_.Contents()));
  EXPECT_EQ(loaded_.Contents().next_keyframe, 101 * (SmallMaps::kNext - first));
  EXPECT_EQ(loaded_.keyframes().size(), maps_.map.keyframes().size());
}

TEST_F(MapContentsTest, TheLoadedMapGoesOnAsAnyOther) {
  Map& loaded = Reload();
  loaded.JoinTo(3, ShiftedBy(1.0));
  EXPECT_EQ(loaded.Graph().merge->old_map_id, 1);
  EXPECT_EQ(loaded.dormant_keyframes(), 0u);
  loaded.CullKeyframe(6);
  EXPECT_TRUE(loaded.KeyframePose(5).matrix().allFinite());
  EXPECT_EQ(loaded.Graph().keyframes.size(), 8u);
}

}  // namespace
}  // namespace semantic_slam
