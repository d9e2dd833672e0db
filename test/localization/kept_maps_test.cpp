// Maps that are written to a file, and gone on with or only localized in.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <gtest/gtest.h>

#include "localization/room_views.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/localization/visual_localization.h"
#include "testing/expect_error.h"
#include "testing/small_room.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

constexpr int kImagesToNewMap = 5;  // the first after kNewMapAfterS
constexpr double kToleranceM = 0.03;
constexpr int kDeskImages = 10;

std::string Content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A camera that writes down which image is the next.
class Camera {
 public:
  RgbdImage See(const Rigid3d& T_world_camera) {
    return SmallRoomImage(T_world_camera, NextStamp());
  }
  RgbdImage SeeNothing() { return BlankImage(NextStamp()); }

 private:
  Stamp NextStamp() {
    return {1'000'000'000'000 + 66'666'666 * static_cast<std::int64_t>(image_++)};
  }

  int image_ = 0;
};

class KeptMapsTest : public testing::TestWithParam<MappingMode> {
 protected:
  KeptMapsTest() : localization_(Make()), path_(folder_ / "room.map") {}

  static std::unique_ptr<VisualLocalization> Make() {
    auto localization =
        std::make_unique<VisualLocalization>(RoomOptions(), SmallCamera(), GetParam());
    localization->SetStart(Looking(0.0, -0.15));  // so that the first map's frame is the room's
    return localization;
  }

  TrackedImage Track(VisualLocalization& localization, const RgbdImage& image) {
    const TrackedImage tracked = localization.Track(image);
    localization.Finish();  // the camera waits for the map
    return tracked;
  }
  TrackedImage Show(const Rigid3d& T_world_camera) {
    return Track(*localization_, camera_.See(T_world_camera));
  }

  void LookAtTheDesk() {
    for (int i = 0; i < kDeskImages; ++i) {
      ASSERT_EQ(Show(Looking(0.0, -0.15 + 0.03 * i)).status, TrackingStatus::kTracking) << i;
    }
  }

  // Keeps the map of the desk. From then on `localization_` is a new one, which has loaded it.
  void BeginAnew() {
    LookAtTheDesk();
    localization_->SaveMap(path_);
    kept_ = localization_->keyframe_graph();
    localization_ = Make();
    localization_->LoadMap(path_);
  }

  std::string Refusal(const std::string& path) {
    return MessageOf<InputError>([&] { localization_->LoadMap(path); });
  }

  // That loading `path` is refused with these words, and the map that runs goes on as if nothing
  // had been.
  void ExpectRefused(const std::string& path, std::initializer_list<const char*> words) {
    LookAtTheDesk();
    const KeyframeGraph before = localization_->keyframe_graph();
    const std::vector<ColouredPoint> points = localization_->map_points();
    ExpectOneLineWith(Refusal(path), words);
    EXPECT_EQ(localization_->revision(), before.revision);
    EXPECT_EQ(localization_->map_points(), points);
    const TrackedImage next = Show(Looking(0.0, 0.15));
    EXPECT_EQ(next.status, TrackingStatus::kTracking);
    EXPECT_EQ(next.map_id, before.map_id);
  }

  const TemporaryFolder folder_;
  Camera camera_;
  std::unique_ptr<VisualLocalization> localization_;
  const std::string path_;
  KeyframeGraph kept_;
};

TEST_P(KeptMapsTest, AKnownPlaceIsFoundInALoadedMapAtOnce) {
  BeginAnew();
  const KeyframeGraph loaded = localization_->keyframe_graph();
  EXPECT_EQ(loaded.reason, RevisionReason::kLoad);
  EXPECT_EQ(loaded.map_id, 1);
  ASSERT_EQ(loaded.keyframes.size(), kept_.keyframes.size());
  for (std::size_t i = 0; i < loaded.keyframes.size(); ++i) {
    EXPECT_EQ(loaded.keyframes[i].id, kept_.keyframes[i].id);
    EXPECT_EQ(loaded.keyframes[i].T_map_keyframe.matrix(),
              kept_.keyframes[i].T_map_keyframe.matrix());
  }
  const TrackedImage found = Show(Looking(0.05, 0.02));
  ASSERT_EQ(found.status, TrackingStatus::kTracking);
  EXPECT_EQ(found.map_id, 1);
  EXPECT_LT(DistanceBetween(found.T_map_camera, Looking(0.05, 0.02)), kToleranceM);
  EXPECT_EQ(found.T_odom_camera.matrix(), Looking(0.0, -0.15).matrix());  // odom begins where told
}

TEST_P(KeptMapsTest, ALoadedMapGrows) {
  BeginAnew();
  for (int i = 0; i < 12; ++i) {
    const TrackedImage tracked = Show(Looking(0.05 * i, 0.02));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracking) << i;
    EXPECT_LT(DistanceBetween(tracked.T_map_camera, Looking(0.05 * i, 0.02)), kToleranceM) << i;
  }
  const KeyframeGraph grown = localization_->keyframe_graph();
  EXPECT_GT(grown.keyframes.size(), kept_.keyframes.size());
  EXPECT_EQ(grown.keyframes[kept_.keyframes.size()].id, kept_.keyframes.back().id + 1);
  for (const KeyframeNode& node : grown.keyframes)
    EXPECT_EQ(node.parent_id == kNoKeyframe, node.id == 0);
}

TEST_P(KeptMapsTest, LoadedIntoARunningOneIdsAndOdomGoOn) {
  LookAtTheDesk();
  localization_->SaveMap(path_);
  const KeyframeGraph before = localization_->keyframe_graph();
  localization_->LoadMap(path_);
  const KeyframeGraph loaded = localization_->keyframe_graph();
  EXPECT_EQ(loaded.map_id, before.map_id + 1);
  EXPECT_GT(loaded.revision, before.revision);
  EXPECT_EQ(loaded.keyframes.front().id, before.keyframes.back().id + 1) << "an id was used again";
  EXPECT_EQ(loaded.keyframes.size(), before.keyframes.size());
  const TrackedImage found = Show(Looking(0.0, 0.0));
  ASSERT_EQ(found.status, TrackingStatus::kTracking);
  EXPECT_LT(DistanceBetween(found.T_map_camera, Looking(0.0, 0.0)), kToleranceM);
  EXPECT_LT(DistanceBetween(found.T_odom_camera, Looking(0.0, -0.15 + 0.03 * (kDeskImages - 1))),
            kToleranceM);
  EXPECT_GE(found.keyframe_id, loaded.keyframes.front().id);
}

TEST_P(KeptMapsTest, AnUnknownPlaceBeginsAMapBesideThatIsJoinedLater) {
  BeginAnew();
  for (int i = 0; i < kImagesToNewMap; ++i) {
    ASSERT_EQ(Show(Looking(M_PI)).status, TrackingStatus::kLost) << i;
  }
  const TrackedImage first = Show(Looking(M_PI));
  ASSERT_EQ(first.status, TrackingStatus::kTracking);
  EXPECT_EQ(first.map_id, 2);
  EXPECT_EQ(first.keyframe_id, kept_.keyframes.back().id + 1);
  for (int i = 1; i <= 60; ++i) {  // round to the desk, 3 degrees an image
    ASSERT_EQ(Show(Looking(M_PI - M_PI * i / 60, 0.05 * std::sin(0.3 * i))).status,
              TrackingStatus::kTracking)
        << i;
  }
  for (int i = 0; i < 6; ++i) Show(Looking(0.0, 0.02 * i));
  const TrackedImage last = Show(Looking(0.0, 0.12));
  EXPECT_EQ(last.map_id, 2);
  EXPECT_EQ(localization_->keyframe_graph().keyframes.front().id, kept_.keyframes.front().id);
  // In the loaded map's frame: nothing but the desk ties the two together.
  EXPECT_LT(DistanceBetween(last.T_map_camera, Looking(0.0, 0.12)), kToleranceM);

  localization_->SaveMap(path_);  // and the two are kept as one
  localization_ = Make();
  localization_->LoadMap(path_);
  const TrackedImage behind = Show(Looking(M_PI));
  ASSERT_EQ(behind.status, TrackingStatus::kTracking);
  EXPECT_EQ(behind.map_id, 1);
}

TEST_P(KeptMapsTest, OnlyLocalizingLeavesTheMapAsItIs) {
  BeginAnew();
  localization_->SetMapping(false);
  const std::uint64_t revision = localization_->revision();
  localization_->SaveMap(folder_ / "before.map");
  for (int i = 0; i < 12; ++i) {
    const TrackedImage tracked = Show(Looking(0.02 * i, 0.01 * i));
    ASSERT_EQ(tracked.status, TrackingStatus::kTracking) << i;
    EXPECT_FALSE(tracked.is_keyframe) << i;
    EXPECT_GE(tracked.keyframe_id, 0) << i;
    EXPECT_LE(tracked.keyframe_id, kept_.keyframes.back().id) << i;
    EXPECT_LT(DistanceBetween(tracked.T_map_camera, Looking(0.02 * i, 0.01 * i)), kToleranceM) << i;
  }
  for (int i = 0; i < 3 * kImagesToNewMap; ++i) {
    ASSERT_EQ(Show(Looking(M_PI)).status, TrackingStatus::kLost) << i;
  }
  const TrackedImage found = Show(Looking(0.0, 0.05));
  EXPECT_EQ(found.status, TrackingStatus::kTracking);
  EXPECT_EQ(found.map_id, 1);
  EXPECT_EQ(localization_->revision(), revision);
  EXPECT_EQ(localization_->rejected_keyframes(), 0u);
  localization_->SaveMap(folder_ / "after.map");
  EXPECT_TRUE(Content(folder_ / "after.map") == Content(folder_ / "before.map"));
}

TEST_P(KeptMapsTest, WithMappingOnAgainTheMapGrows) {
  BeginAnew();
  localization_->SetMapping(false);
  for (int i = 0; i < 5; ++i) Show(Looking(0.0, 0.01 * i));
  const std::size_t keyframes = localization_->keyframe_graph().keyframes.size();
  localization_->SetMapping(true);
  for (int i = 0; i < 8; ++i) {
    ASSERT_EQ(Show(Looking(0.04 * i, 0.05)).status, TrackingStatus::kTracking) << i;
  }
  EXPECT_GT(localization_->keyframe_graph().keyframes.size(), keyframes);
}

TEST_P(KeptMapsTest, RestartedTheCameraIsLookedForInTheMapAlsoBackInTime) {
  BeginAnew();
  Show(Looking(0.0, 0.0));
  localization_->Restart();
  camera_ = Camera();
  const TrackedImage found = Show(Looking(0.0, 0.1));
  ASSERT_EQ(found.status, TrackingStatus::kTracking);
  EXPECT_EQ(found.map_id, 1);
  EXPECT_LT(DistanceBetween(found.T_map_camera, Looking(0.0, 0.1)), kToleranceM);
}

TEST_P(KeptMapsTest, RestartedWithoutAMapOneBegins) {
  Track(*localization_, camera_.SeeNothing());
  localization_->Restart();
  camera_ = Camera();
  EXPECT_EQ(Show(Looking(0.0)).status, TrackingStatus::kTracking);
}

TEST_P(KeptMapsTest, RefusesTheMapOfAnotherCamera) {
  LookAtTheDesk();
  localization_->SaveMap(path_);
  CameraIntrinsics other = SmallIntrinsics();
  other.cx_px = 150.0;
  localization_ = std::make_unique<VisualLocalization>(
      RoomOptions(), std::make_shared<const CameraModel>(other), GetParam());
  ExpectRefused(path_, {"room.map", "cx 159.5", "cx 150"});
}

TEST_P(KeptMapsTest, RefusesTheMapOfAnotherPyramid) {
  LookAtTheDesk();
  localization_->SaveMap(path_);
  LocalizationOptions options = RoomOptions();
  options.features.pyramid_levels = 6;
  localization_ = std::make_unique<VisualLocalization>(options, SmallCamera(), GetParam());
  ExpectRefused(path_, {"room.map", "8 levels", "6 levels"});
}

TEST_P(KeptMapsTest, RefusesAFileThatIsCut) {
  LookAtTheDesk();
  localization_->SaveMap(path_);
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 1);
  localization_ = Make();
  ExpectRefused(path_, {"room.map", "cut short"});
}

TEST_P(KeptMapsTest, RefusesToKeepWhatIsNotThere) {
  ExpectOneLineWith(MessageOf<InputError>([&] { localization_->SaveMap(path_); }),
                    {"room.map", "there is no map yet"});
  EXPECT_FALSE(std::filesystem::exists(path_));
  ExpectOneLineWith(Refusal(path_), {"cannot open", "room.map"});
}

// Mostly for the thread sanitizer.
TEST_P(KeptMapsTest, OthersMaySaveAndLoadWhileItWorks) {
  LookAtTheDesk();
  localization_->SaveMap(path_);
  std::thread other([&] {
    for (int i = 0; i < 6; ++i) {  // without end it could keep the other from ever being served
      localization_->SetMapping(false);
      localization_->SaveMap(path_);
      localization_->LoadMap(path_);
      localization_->SetMapping(true);
    }
  });
  for (int i = 0; i < 12; ++i) {
    EXPECT_EQ(localization_->Track(camera_.See(Looking(0.0, 0.1 - 0.01 * i))).status,
              TrackingStatus::kTracking)
        << i;
  }
  other.join();
}

INSTANTIATE_TEST_SUITE_P(Modes, KeptMapsTest,
                         testing::Values(MappingMode::kInline, MappingMode::kThreaded),
                         [](const auto& mode) {
                           return mode.param == MappingMode::kInline ? "Inline" : "Threaded";
                         });

}  // namespace
}  // namespace semantic_slam
