// The camera is covered, carried off, and uncovered again somewhere else.

#include <gtest/gtest.h>

#include "localization/room_views.h"
#include "semantic_slam/localization/trajectory_recorder.h"
#include "semantic_slam/localization/visual_localization.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr double kImagesPerS = 15.0;
constexpr int kImagesToNewMap = 5;  // the first after so much time

class KidnappingTest : public testing::TestWithParam<MappingMode> {
 protected:
  KidnappingTest() : localization_(RoomOptions(), SmallCamera(), GetParam()) {
    localization_.SetStart(Looking(0.0, -0.15));  // so that the first map's frame is the room's
  }

  TrackedImage Show(const Rigid3d& T_world_camera) {
    return Track(SmallRoomImage(T_world_camera, NextStamp()));
  }

  void LookAtTheDesk() {
    for (int i = 0; i < 10; ++i) {
      ASSERT_EQ(Show(Looking(0.0, -0.15 + 0.03 * i)).status, TrackingStatus::kTracking) << i;
    }
    localization_.Finish();  // so that its places are known before the camera is covered
  }

  void Cover() {
    for (int i = 0; i < 8; ++i) {
      ASSERT_EQ(Track(BlankImage(NextStamp())).status, TrackingStatus::kLost);
    }
  }

  TrackedImage Track(const RgbdImage& image) {
    const TrackedImage tracked = localization_.Track(image);
    if (GetParam() == MappingMode::kThreaded)
      localization_.Finish();  // the camera waits for the map
    recorder_.Add(tracked);
    return tracked;
  }

  Stamp NextStamp() {
    return {1'000'000'000'000 + static_cast<std::int64_t>(1e9 / kImagesPerS) * image_++};
  }

  VisualLocalization localization_;
  TrajectoryRecorder recorder_;
  int image_ = 0;
};

TEST_P(KidnappingTest, AKnownPlaceIsFoundAgainAtOnce) {
  LookAtTheDesk();
  Cover();
  const TrackedImage found = Show(Looking(0.05, 0.0));
  ASSERT_EQ(found.status, TrackingStatus::kTracking);
  EXPECT_EQ(found.map_id, 0);
  EXPECT_LT(DistanceBetween(found.T_map_camera, Looking(0.05, 0.0)), 0.03);
}

TEST_P(KidnappingTest, AnUnknownPlaceBeginsAMapThatIsJoinedLater) {
  LookAtTheDesk();
  Cover();
  const KeyframeGraph before = localization_.keyframe_graph();
  for (int i = 0; i < kImagesToNewMap; ++i) {
    ASSERT_EQ(Show(Looking(M_PI)).status, TrackingStatus::kLost) << i;
  }
  const TrackedImage first = Show(Looking(M_PI));
  ASSERT_EQ(first.status, TrackingStatus::kTracking);
  EXPECT_TRUE(first.is_keyframe);
  EXPECT_EQ(first.map_id, 1);
  const KeyframeGraph second = localization_.keyframe_graph();
  EXPECT_EQ(second.map_id, 1);
  ASSERT_EQ(second.keyframes.size(), 1u);
  EXPECT_GT(second.revision, before.revision);

  // Round to the desk, 3 degrees an image.
  TrackedImage last = first;
  for (int i = 1; i <= 60; ++i) {
    last = Show(Looking(M_PI - M_PI * i / 60, 0.05 * std::sin(0.3 * i)));
    ASSERT_EQ(last.status, TrackingStatus::kTracking) << i;
  }
  for (int i = 0; i < 6; ++i) last = Show(Looking(0.0, 0.02 * i));
  localization_.Finish();
  last = Show(Looking(0.0, 0.12));

  EXPECT_EQ(last.map_id, 1);
  const KeyframeGraph joined = localization_.keyframe_graph();
  EXPECT_EQ(joined.map_id, 1);
  EXPECT_EQ(joined.keyframes.front().id, 0);  // the old map's keyframes are back
  int roots = 0;
  for (const KeyframeNode& node : joined.keyframes) roots += node.parent_id == kNoKeyframe;
  EXPECT_EQ(roots, 1);
  // In the old map's frame again: 3 cm, as nothing but the desk ties the two together.
  EXPECT_LT(DistanceBetween(last.T_map_camera, Looking(0.0, 0.12)), 0.03);
  // All that was tracked is in one trajectory, on both sides of the gap.
  EXPECT_EQ(recorder_.Corrected(joined).size(), recorder_.tracked());
}

TEST_P(KidnappingTest, ALensThatStaysCoveredBeginsNoMap) {
  LookAtTheDesk();
  Cover();
  Cover();
  EXPECT_EQ(localization_.keyframe_graph().map_id, 0);
}

TEST_P(KidnappingTest, AResetForgetsTheOldMapsToo) {
  LookAtTheDesk();
  Cover();
  for (int i = 0; i <= kImagesToNewMap; ++i) Show(Looking(M_PI));
  ASSERT_EQ(localization_.keyframe_graph().map_id, 1);
  localization_.Reset();
  EXPECT_EQ(localization_.keyframe_graph().map_id, 2);
  EXPECT_EQ(Show(Looking(0.0)).status, TrackingStatus::kTracking);
  EXPECT_EQ(localization_.keyframe_graph().keyframes.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Modes, KidnappingTest,
                         testing::Values(MappingMode::kInline, MappingMode::kThreaded),
                         [](const auto& mode) {
                           return mode.param == MappingMode::kInline ? "Inline" : "Threaded";
                         });

}  // namespace
}  // namespace semantic_slam
