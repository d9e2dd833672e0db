#include "semantic_slam/local_mapping/local_mapper.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "semantic_slam/tracking/tracker.h"
#include "testing/expect_error.h"
#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr int kKeyframes = 6;

Rigid3d TruePose(int image) {
  return HandheldPath::T_world_camera(3.0 + 0.1 * image);
}

// Rendered once for all tests.
std::shared_ptr<const FrameFeatures> RoomFrame(int image) {
  static std::map<int, std::shared_ptr<const FrameFeatures>> frames;
  auto& frame = frames[image];
  const Stamp stamp{1'000'000'000'000 + 100'000'000 * static_cast<std::int64_t>(image)};
  if (frame == nullptr) frame = SmallRoomFeatures(TruePose(image), stamp);
  return frame;
}

// A map in the making: tracking makes every image a keyframe, in the room's frame.
class LocalMapperTest : public testing::Test {
 protected:
  LocalMapperTest() { TrackRoom(); }

  void TrackRoom() {
    map_ = std::make_unique<Map>(SmallExtractor().scales());
    mapper_ = std::make_unique<LocalMapper>(LocalMapperOptions(), SmallCamera(), *map_);
    TrackerOptions options;
    options.max_keyframe_gap = 1;
    const PlaceIndex index{PlaceIndexOptions()};
    Tracker tracker(options, ReadoutOptions(), SmallCamera(), *map_, index);
    tracker.SetStart(TruePose(0));
    for (int i = 0; i < kKeyframes; ++i) {
      const auto result = tracker.Track(RoomFrame(i), true);
      ASSERT_EQ(result.new_keyframe, i);
      ASSERT_EQ(result.image.status, TrackingStatus::kTracking);
    }
  }

  void Process(KeyframeId id) { mapper_->Process(id, timer_); }

  // Adds what a camera that stands still would: the view of the last keyframe once more.
  KeyframeId AddTheLastViewAgain() {
    const Keyframe& last = *map_->keyframes().rbegin()->second;
    const std::vector<PointId> points = last.points;
    const KeyframeId id = map_->AddKeyframe(last.features, last.T_map_camera).id;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i] != kNoPoint) map_->AddObservation(points[i], id, static_cast<int>(i));
    }
    map_->UpdateCovisibility(id);
    return id;
  }

  std::unique_ptr<Map> map_;
  std::unique_ptr<LocalMapper> mapper_;
  StageTimer timer_;
};

TEST_F(LocalMapperTest, PutsKeyframesWhereTheyBelong) {
  const KeyframeId newest = kKeyframes - 1;
  const Rigid3d T_first = map_->FindKeyframe(0)->T_map_camera;
  for (KeyframeId id = newest - 1; id <= newest; ++id) {
    Keyframe& keyframe = *map_->FindKeyframe(id);
    keyframe.T_map_camera = Nudged(keyframe.T_map_camera, 0.02, 0.01, 5);
  }
  Process(newest);
  for (KeyframeId id = newest - 1; id <= newest; ++id) {
    // As good as tracking without noise: a pixel of this camera is 8 mm at 2 m.
    EXPECT_LT(DistanceBetween(map_->KeyframePose(id), TruePose(static_cast<int>(id))), 0.01) << id;
    EXPECT_LT(AngleBetween(map_->KeyframePose(id), TruePose(static_cast<int>(id))), 0.005) << id;
  }
  EXPECT_EQ(map_->FindKeyframe(0)->T_map_camera.matrix(), T_first.matrix());
}

TEST_F(LocalMapperTest, TellsThatTheMapHasChanged) {
  const std::uint64_t revision = map_->revision();
  Process(kKeyframes - 1);
  EXPECT_GT(map_->revision(), revision);
  EXPECT_EQ(map_->Graph().reason, RevisionReason::kLocalBa);
  std::vector<std::string> stages;
  for (const StageTiming& timing : timer_.Timings()) stages.push_back(timing.stage);
  EXPECT_EQ(stages,
            (std::vector<std::string>{"local_mapping.apply", "local_mapping.bundle_adjustment",
                                      "local_mapping.fuse", "local_mapping.triangulate"}));
}

TEST_F(LocalMapperTest, DoesNothingForAKeyframeThatIsGone) {
  const std::uint64_t revision = map_->revision();
  map_->CullKeyframe(2);
  Process(2);
  Process(12345);
  EXPECT_EQ(map_->revision(), revision);
}

TEST_F(LocalMapperTest, WorksOnTheVeryFirstKeyframe) {
  map_->Clear();
  mapper_->Reset(SmallCamera());
  const KeyframeId first = AddKeyframeWithPoints(*map_, RoomFrame(0), TruePose(0));
  const std::size_t points = map_->point_count();
  Process(first);
  EXPECT_EQ(map_->KeyframePose(first).matrix(), TruePose(0).matrix());
  EXPECT_EQ(map_->point_count(), points);
}

TEST_F(LocalMapperTest, MergesPointsThatAreThereTwice) {
  const KeyframeId newest = kKeyframes - 1;
  const std::vector<PointId> seen = map_->FindKeyframe(newest)->points;
  std::map<PointId, PointId> twin_of;
  for (std::size_t i = 0; i < seen.size() && twin_of.size() < 40; ++i) {
    const MapPoint* point = map_->FindPoint(seen[i]);
    if (point == nullptr || point->observations.size() < 4) continue;
    // As if tracking had not recognised it: a point of its own, 2 mm beside.
    const Eigen::Vector3d beside = point->position + Eigen::Vector3d(0.002, 0.0, 0.0);
    map_->RemoveObservation(seen[i], newest);
    twin_of[map_->AddPoint(beside, newest, static_cast<int>(i)).id] = seen[i];
  }
  ASSERT_EQ(twin_of.size(), 40u);
  Process(newest);
  int merged = 0;
  for (const auto& [twin, original] : twin_of) {
    merged += map_->Resolve(twin) != kNoPoint && map_->Resolve(twin) == map_->Resolve(original);
  }
  EXPECT_GE(merged, 30);  // some look too different, or are too far off after all
}

TEST_F(LocalMapperTest, DropsObservationsThatDoNotFit) {
  const KeyframeId newest = kKeyframes - 1;
  // Two points exchange the features that show them.
  std::vector<std::pair<PointId, int>> chosen;
  const Keyframe& keyframe = *map_->FindKeyframe(newest);
  for (std::size_t i = 0; i < keyframe.points.size() && chosen.size() < 2; i += 50) {
    const MapPoint* point = map_->FindPoint(keyframe.points[i]);
    if (point != nullptr && point->observations.size() >= 4) chosen.emplace_back(point->id, i);
  }
  ASSERT_EQ(chosen.size(), 2u);
  for (const auto& [id, feature] : chosen) map_->RemoveObservation(id, newest);
  map_->AddObservation(chosen[0].first, newest, chosen[1].second);
  map_->AddObservation(chosen[1].first, newest, chosen[0].second);
  Process(newest);
  EXPECT_NE(map_->FindKeyframe(newest)->points[chosen[0].second], chosen[1].first);
  EXPECT_NE(map_->FindKeyframe(newest)->points[chosen[1].second], chosen[0].first);
}

TEST_F(LocalMapperTest, ErasesYoungPointsThatAreSeldomFound) {
  const KeyframeId newest = kKeyframes - 1;
  std::vector<PointId> bad, good;
  for (const PointId id : map_->FindKeyframe(newest)->points) {
    MapPoint* point = map_->FindPoint(id);
    if (point == nullptr || point->reference != newest) continue;
    point->visible = 10;
    point->found = bad.size() <= good.size() ? 2 : 3;  // a quarter is needed
    (point->found == 2 ? bad : good).push_back(id);
  }
  ASSERT_GT(good.size(), 10u);
  Process(newest);
  for (const PointId id : bad) EXPECT_EQ(map_->FindPoint(id), nullptr);
  EXPECT_GT(std::count_if(good.begin(), good.end(),
                          [&](PointId id) { return map_->Resolve(id) != kNoPoint; }),
            static_cast<std::ptrdiff_t>(good.size() / 2));
}

TEST_F(LocalMapperTest, ErasesPointsThatTooFewHaveSeenAfterTheirProbation) {
  const KeyframeId born = kKeyframes - 1;
  Process(born);
  std::vector<PointId> weak, good;
  for (const PointId id : map_->FindKeyframe(born)->points) {
    const MapPoint* point = map_->FindPoint(id);
    if (point == nullptr) continue;
    if (point->observations.size() >= 3) good.push_back(id);
    if (point->observations.size() == 1) weak.push_back(id);
  }
  ASSERT_FALSE(weak.empty());
  ASSERT_FALSE(good.empty());
  const int probation = LocalMapperOptions().probation_keyframes;
  for (KeyframeId later = born + 1; later <= born + probation; ++later) {
    for (const PointId id : weak) EXPECT_NE(map_->FindPoint(id), nullptr) << later;
    ASSERT_EQ(map_->AddKeyframe(SquaresFeatures(1), TruePose(0)).id, later);  // of somewhere else
    map_->UpdateCovisibility(later);
    Process(later);
  }
  for (const PointId id : weak) EXPECT_EQ(map_->FindPoint(id), nullptr);
  for (const PointId id : good) EXPECT_NE(map_->FindPoint(id), nullptr);
}

TEST_F(LocalMapperTest, AYoungPointThatAnOlderKeyframeShowsTooIsOnProbationStill) {
  const KeyframeId newest = kKeyframes - 1;
  const auto& seen = map_->FindKeyframe(newest)->points;
  const auto young = std::find_if(seen.begin(), seen.end(), [&](PointId id) {
    const MapPoint* point = map_->FindPoint(id);
    return point != nullptr && point->reference == newest;
  });
  ASSERT_NE(young, seen.end());
  const PointId id = *young;
  map_->ErasePoint(map_->FindKeyframe(0)->points[0]);
  map_->AddObservation(id, 0, 0);
  map_->FindPoint(id)->visible = 10;
  map_->FindPoint(id)->found = 2;
  LocalMapperOptions options;
  options.probation_keyframes = 3;  // keyframe 0 is five before
  LocalMapper(options, SmallCamera(), *map_).Process(newest, timer_);
  EXPECT_EQ(map_->FindPoint(id), nullptr);
}

TEST_F(LocalMapperTest, APointThatLosesItsKeyframesLaterGoesToo) {
  const KeyframeId newest = kKeyframes - 1;
  std::vector<PointId> lonely;
  for (const PointId id : map_->FindKeyframe(0)->points) {
    const MapPoint* point = map_->FindPoint(id);
    if (point == nullptr || point->observations.size() < 3 || lonely.size() == 10) continue;
    lonely.push_back(id);
    while (map_->FindPoint(id)->observations.size() > 2) {
      map_->RemoveObservation(id, map_->FindPoint(id)->observations.back().keyframe);
    }
  }
  ASSERT_EQ(lonely.size(), 10u);
  LocalMapperOptions options;
  options.probation_keyframes = 3;  // keyframe 0 made these points, five before the newest
  options.fusion_neighbours = 0;    // else they are found again
  LocalMapper(options, SmallCamera(), *map_).Process(newest, timer_);
  for (const PointId id : lonely) EXPECT_EQ(map_->FindPoint(id), nullptr);
}

TEST_F(LocalMapperTest, FindsMorePointsInTheNewestKeyframe) {
  const KeyframeId newest = kKeyframes - 1;
  const std::vector<PointId> seen = map_->FindKeyframe(newest)->points;
  std::vector<PointId> overlooked;
  for (const PointId id : seen) {
    const MapPoint* point = map_->FindPoint(id);
    if (point == nullptr || point->observations.size() < 4 || overlooked.size() == 40) continue;
    map_->RemoveObservation(id, newest);
    overlooked.push_back(id);
  }
  ASSERT_EQ(overlooked.size(), 40u);
  Process(newest);
  const std::vector<PointId>& now = map_->FindKeyframe(newest)->points;
  const auto found = std::count_if(overlooked.begin(), overlooked.end(), [&](PointId id) {
    return std::find(now.begin(), now.end(), id) != now.end();
  });
  EXPECT_GE(found, 30);
}

TEST_F(LocalMapperTest, NeverCullsTheFirstKeyframe) {
  map_->Clear();
  mapper_->Reset(SmallCamera());
  const KeyframeId first = AddKeyframeWithPoints(*map_, RoomFrame(0), TruePose(0));
  KeyframeId newest = first;
  for (int i = 0; i < 6; ++i) newest = AddTheLastViewAgain();
  Process(newest);
  EXPECT_NE(map_->FindKeyframe(first), nullptr);
  EXPECT_LT(map_->keyframes().size(), 7u);
}

TEST_F(LocalMapperTest, CullsViewsThatAddNothing) {
  KeyframeId newest = kKeyframes - 1;
  for (int i = 0; i < 4; ++i) newest = AddTheLastViewAgain();
  Process(newest);
  const auto& alive = map_->keyframes();
  EXPECT_LT(static_cast<int>(alive.size()), kKeyframes + 4);
  EXPECT_NE(map_->FindKeyframe(newest), nullptr);
  const KeyframeGraph graph = map_->Graph();
  ASSERT_EQ(graph.keyframes.size(), kKeyframes + 4u);
  for (const KeyframeNode& node : graph.keyframes) {
    EXPECT_EQ(node.culled, map_->FindKeyframe(node.id) == nullptr);
  }
}

TEST_F(LocalMapperTest, TheSameMapGivesTheSameBytes) {
  const auto process_all = [&] {
    for (KeyframeId id = 0; id < kKeyframes; ++id) Process(id);
    return std::make_pair(map_->Graph(), map_->ColouredPoints());
  };
  const auto first = process_all();
  TrackRoom();
  const auto again = process_all();
  EXPECT_EQ(first.second, again.second);
  ASSERT_EQ(first.first.keyframes.size(), again.first.keyframes.size());
  for (std::size_t i = 0; i < first.first.keyframes.size(); ++i) {
    EXPECT_EQ(first.first.keyframes[i].T_map_keyframe.matrix(),
              again.first.keyframes[i].T_map_keyframe.matrix())
        << i;
  }
}

TEST_F(LocalMapperTest, RefusesOptionsOutOfRange) {
  LocalMapperOptions options;
  options.window_keyframes = 1;
  EXPECT_EQ(MessageOf<ConfigError>([&] { LocalMapper(options, SmallCamera(), *map_); }),
            "window_keyframes = 1, but must be in [2, 200]");
}

}  // namespace
}  // namespace semantic_slam
