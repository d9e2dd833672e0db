#include "semantic_slam/localization/visual_localization.h"

#include <atomic>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/yaml_options.h"
#include "testing/expect_error.h"
#include "testing/small_sequence.h"
#include "testing/temporary_folder.h"

namespace semantic_slam {
namespace {

std::unique_ptr<VisualLocalization> Start(MappingMode mode) {
  auto localization =
      std::make_unique<VisualLocalization>(SmallSequenceOptions(), SmallCamera(), mode);
  localization->SetStart(SmallSequencePose(0));  // so that the map's frame is the room's
  return localization;
}

std::vector<TrackedImage> TrackAll(VisualLocalization& localization) {
  std::vector<TrackedImage> tracked;
  for (int i = 0; i < kSmallSequenceImages; ++i) {
    tracked.push_back(localization.Track(SmallSequenceImage(i)));
  }
  return tracked;
}

// Two centimetres and a degree: without noise, what a few pixels of this camera make.
void ExpectFollowsTheCamera(const std::vector<TrackedImage>& tracked) {
  for (int i = 0; i < static_cast<int>(tracked.size()); ++i) {
    ASSERT_EQ(tracked[i].status, TrackingStatus::kTracking) << i;
    EXPECT_LT(DistanceBetween(tracked[i].T_map_camera, SmallSequencePose(i)), 0.02) << i;
    EXPECT_LT(AngleBetween(tracked[i].T_map_camera, SmallSequencePose(i)), M_PI / 180.0) << i;
    EXPECT_LT(DistanceBetween(tracked[i].T_odom_camera, SmallSequencePose(i)), 0.02) << i;
  }
}

void ExpectSameBytes(const TrackedImage& a, const TrackedImage& b) {
  EXPECT_EQ(a.stamp, b.stamp);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.keyframe_id, b.keyframe_id);
  EXPECT_EQ(a.inliers, b.inliers);
  EXPECT_EQ(a.is_keyframe, b.is_keyframe);
  EXPECT_EQ(a.T_keyframe_camera.matrix(), b.T_keyframe_camera.matrix());
  EXPECT_EQ(a.T_map_camera.matrix(), b.T_map_camera.matrix());
  EXPECT_EQ(a.T_odom_camera.matrix(), b.T_odom_camera.matrix());
}

void ExpectSameBytes(const KeyframeGraph& a, const KeyframeGraph& b) {
  EXPECT_EQ(a.map_id, b.map_id);
  EXPECT_EQ(a.revision, b.revision);
  ASSERT_EQ(a.keyframes.size(), b.keyframes.size());
  for (std::size_t i = 0; i < a.keyframes.size(); ++i) {
    EXPECT_EQ(a.keyframes[i].id, b.keyframes[i].id);
    EXPECT_EQ(a.keyframes[i].parent_id, b.keyframes[i].parent_id);
    EXPECT_EQ(a.keyframes[i].culled, b.keyframes[i].culled);
    EXPECT_EQ(a.keyframes[i].T_map_keyframe.matrix(), b.keyframes[i].T_map_keyframe.matrix());
    EXPECT_EQ(a.keyframes[i].T_parent_keyframe.matrix(), b.keyframes[i].T_parent_keyframe.matrix());
  }
}

TEST(VisualLocalizationTest, FollowsTheCameraAndBuildsAMap) {
  const auto localization = Start(MappingMode::kInline);
  const std::vector<TrackedImage> tracked = TrackAll(*localization);
  ExpectFollowsTheCamera(tracked);
  EXPECT_EQ(tracked[0].T_map_camera.matrix(), SmallSequencePose(0).matrix());

  const KeyframeGraph graph = localization->keyframe_graph();
  EXPECT_EQ(graph.revision, localization->revision());
  EXPECT_GE(graph.keyframes.size(), 5u);  // one image in three
  for (const KeyframeNode& node : graph.keyframes) {
    EXPECT_EQ(node.id, &node - graph.keyframes.data());
    EXPECT_EQ(node.parent_id == kNoKeyframe, node.id == 0);
  }
  EXPECT_GT(localization->map_points().size(), 300u);
  EXPECT_EQ(localization->rejected_keyframes(), 0u);  // inline, local mapping is never busy
}

TEST(VisualLocalizationTest, InlineTheSameImagesGiveTheSameBytes) {
  const auto first = Start(MappingMode::kInline), again = Start(MappingMode::kInline);
  for (int i = 0; i < kSmallSequenceImages; ++i) {
    SCOPED_TRACE(i);
    ExpectSameBytes(first->Track(SmallSequenceImage(i)), again->Track(SmallSequenceImage(i)));
  }
  ExpectSameBytes(first->keyframe_graph(), again->keyframe_graph());
  EXPECT_EQ(first->map_points(), again->map_points());
}

TEST(VisualLocalizationTest, ThreadedItFollowsTheSameCamera) {
  const auto localization = Start(MappingMode::kThreaded);
  ExpectFollowsTheCamera(TrackAll(*localization));
  localization->Finish();
  const std::uint64_t revision = localization->revision();
  EXPECT_GE(localization->keyframe_graph().keyframes.size(), 2u);
  EXPECT_EQ(localization->revision(), revision) << "local mapping goes on after Finish()";
}

TEST(VisualLocalizationTest, ThreadedItMayBeDestroyedAtAnyTime) {
  for (int images = 0; images < 4; ++images) {
    const auto localization = Start(MappingMode::kThreaded);
    for (int i = 0; i < images; ++i) localization->Track(SmallSequenceImage(i));
  }
}

// Mostly for the thread sanitizer: everything but Track() may be called from anywhere at any time.
TEST(VisualLocalizationTest, OthersMayLookWhileItWorks) {
  const auto localization = Start(MappingMode::kThreaded);
  std::atomic<bool> done{false};
  std::thread reader([&] {
    std::uint64_t revision = 0;
    while (!done) {
      const std::uint64_t now = localization->revision();
      EXPECT_GE(now, revision);
      revision = now;
      EXPECT_GE(localization->keyframe_graph().revision, now);
      localization->map_points();
      localization->features();
      localization->timings();
      localization->rejected_keyframes();
      std::this_thread::yield();
    }
  });
  ExpectFollowsTheCamera(TrackAll(*localization));
  localization->Finish();
  done = true;
  reader.join();
}

TEST(VisualLocalizationTest, OthersMayResetWhileItWorks) {
  const auto localization = Start(MappingMode::kThreaded);
  std::thread other([&] {
    for (int i = 0; i < 5; ++i) {
      localization->Reset();
      localization->SetStart(SmallSequencePose(0));
      localization->Finish();
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  });
  std::set<KeyframeId> ids;
  for (int i = 0; i < kSmallSequenceImages; ++i) {
    const TrackedImage image = localization->Track(SmallSequenceImage(i));
    if (image.is_keyframe) {
      EXPECT_TRUE(ids.insert(image.keyframe_id).second) << "an id was used again";
    }
  }
  other.join();
  EXPECT_EQ(localization->keyframe_graph().map_id, 5);
}

TEST(VisualLocalizationTest, ResetStartsANewMapAndGoesOnWithTheIds) {
  for (const MappingMode mode : {MappingMode::kInline, MappingMode::kThreaded}) {
    const auto localization = Start(mode);
    for (int i = 0; i < 8; ++i) localization->Track(SmallSequenceImage(i));
    localization->Finish();
    const KeyframeGraph before = localization->keyframe_graph();
    localization->Reset();
    EXPECT_GT(localization->revision(), before.revision);
    EXPECT_EQ(localization->keyframe_graph().reason, RevisionReason::kReset);
    EXPECT_TRUE(localization->keyframe_graph().keyframes.empty());
    EXPECT_TRUE(localization->map_points().empty());

    const TrackedImage first = localization->Track(SmallSequenceImage(0));  // back in time
    EXPECT_EQ(first.status, TrackingStatus::kTracking);
    EXPECT_EQ(first.map_id, before.map_id + 1);
    EXPECT_EQ(first.keyframe_id, before.keyframes.back().id + 1);
    EXPECT_EQ(first.T_map_camera.matrix(), SmallSequencePose(0).matrix());
    EXPECT_EQ(first.T_odom_camera.matrix(), SmallSequencePose(0).matrix());
    EXPECT_EQ(localization->keyframe_graph().map_id, first.map_id);
  }
}

// The middle of SmallCamera()'s picture: a camera with other bounds and another principal point.
const cv::Rect kMiddle(40, 20, 240, 200);

std::shared_ptr<const CameraModel> MiddleCamera() {
  CameraIntrinsics intrinsics = SmallIntrinsics();
  intrinsics.width_px = kMiddle.width;
  intrinsics.height_px = kMiddle.height;
  intrinsics.cx_px -= kMiddle.x;
  intrinsics.cy_px -= kMiddle.y;
  return std::make_shared<const CameraModel>(intrinsics);
}

RgbdImage MiddleImage(int i) {
  RgbdImage image = SmallSequenceImage(i);
  image.colour = image.colour(kMiddle).clone();
  image.depth_m = image.depth_m(kMiddle).clone();
  return image;
}

TEST(VisualLocalizationTest, AnotherCameraStartsANewMapAndGoesOnWithTheIds) {
  for (const MappingMode mode : {MappingMode::kInline, MappingMode::kThreaded}) {
    const auto localization = Start(mode);
    for (int i = 0; i < 8; ++i) localization->Track(SmallSequenceImage(i));
    localization->Finish();
    const KeyframeGraph before = localization->keyframe_graph();
    localization->Reset(MiddleCamera());
    EXPECT_GT(localization->revision(), before.revision);
    EXPECT_THROW(localization->Track(SmallSequenceImage(8)), InputError) << "of the camera before";

    std::vector<TrackedImage> tracked;
    for (int i = 0; i < kSmallSequenceImages; ++i) {
      tracked.push_back(localization->Track(MiddleImage(i)));
    }
    // Poses that fit: features, tracking and local mapping all use the new principal point.
    ExpectFollowsTheCamera(tracked);
    EXPECT_EQ(tracked[0].map_id, before.map_id + 1);
    EXPECT_EQ(tracked[0].keyframe_id, before.keyframes.back().id + 1);
    localization->Finish();
    EXPECT_GE(localization->keyframe_graph().keyframes.size(), 3u);
  }
}

TEST(VisualLocalizationTest, RefusesAnImageThatIsNotLaterThanTheOneBefore) {
  const auto localization = Start(MappingMode::kInline);
  localization->Track(SmallSequenceImage(1));
  const auto error_of = [&](int image) {
    return MessageOf<InputError>([&] { localization->Track(SmallSequenceImage(image)); });
  };
  EXPECT_EQ(error_of(0), "image at " + ToString(SmallSequenceStamp(0)) +
                             " s is not later than the one before at " +
                             ToString(SmallSequenceStamp(1)) + " s");
  EXPECT_NE(error_of(1), "");
  EXPECT_EQ(error_of(2), "");
}

TEST(VisualLocalizationTest, ARefusedImageChangesNothing) {
  const auto disturbed = Start(MappingMode::kInline), calm = Start(MappingMode::kInline);
  RgbdImage of_another_size;
  of_another_size.stamp = SmallSequenceStamp(kSmallSequenceImages);  // later than all others
  of_another_size.colour = cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(0));
  of_another_size.depth_m = cv::Mat(120, 160, CV_32FC1, cv::Scalar::all(1));
  for (int i = 0; i < 6; ++i) {
    SCOPED_TRACE(i);
    ExpectSameBytes(disturbed->Track(SmallSequenceImage(i)), calm->Track(SmallSequenceImage(i)));
    EXPECT_THROW(disturbed->Track(of_another_size), InputError);
    EXPECT_THROW(disturbed->Track(SmallSequenceImage(i)), InputError);
  }
  ExpectSameBytes(disturbed->keyframe_graph(), calm->keyframe_graph());
}

TEST(VisualLocalizationTest, ShowsTheFeaturesOfTheLastImage) {
  const auto localization = Start(MappingMode::kInline);
  EXPECT_TRUE(localization->features().empty());
  TrackedImage image;
  for (int i = 0; i < 3; ++i) image = localization->Track(SmallSequenceImage(i));
  ASSERT_FALSE(image.is_keyframe);  // those show their new points too
  const std::vector<FeatureView> features = localization->features();
  EXPECT_GT(features.size(), 300u);
  int inliers = 0;
  for (const FeatureView& feature : features) {
    inliers += feature.is_inlier;
    EXPECT_GE(feature.size_px, 31.0f);
    EXPECT_TRUE(cv::Rect(0, 0, 320, 240)
                    .contains(cv::Point(cvRound(feature.pixel.x()), cvRound(feature.pixel.y()))));
  }
  EXPECT_EQ(inliers, image.inliers);
}

TEST(VisualLocalizationTest, TellsHowLongEveryStageTook) {
  const auto localization = Start(MappingMode::kInline);
  for (int i = 0; i < 4; ++i) localization->Track(SmallSequenceImage(i));
  std::map<std::string, std::int64_t> counts;
  for (const StageTiming& timing : localization->timings()) counts[timing.stage] = timing.count;
  EXPECT_EQ(counts["tracking"], 4);
  EXPECT_EQ(counts["tracking.features"], 4);
  EXPECT_EQ(counts["tracking.pose"], 4);
  EXPECT_GE(counts["local_mapping"], 2);  // the first image's and the fourth's at the latest
}

TEST(LocalizationOptionsTest, AreReadByGroup) {
  const TemporaryFolder folder;
  const std::string path =
      folder.Write("options.yaml", "features: {max_features: 700}\ntracking: {min_inliers: 21}\n");
  YamlReader file(LoadYamlMap(path), path);
  LocalizationOptions options;
  ReadOptionGroups(file, options);
  EXPECT_EQ(options.features.max_features, 700);
  EXPECT_EQ(options.tracking.min_inliers, 21);
  EXPECT_EQ(options.local_mapping.window_keyframes, LocalMapperOptions().window_keyframes);
  file.Finish();  // nothing is left over
}

TEST(LocalizationOptionsTest, AMisspeltOneIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("options.yaml", "tracking:\n  min_inlier: 21\n");
  YamlReader file(LoadYamlMap(path), path);
  LocalizationOptions options;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { ReadOptionGroups(file, options); }),
                    {"options.yaml:2", "tracking/min_inlier"});
}

TEST(LocalizationOptionsTest, AreCheckedAtConstruction) {
  LocalizationOptions options;
  options.local_mapping.redundant_share = 2.0;
  EXPECT_EQ(MessageOf<ConfigError>(
                [&] { VisualLocalization(options, SmallCamera(), MappingMode::kInline); }),
            "redundant_share = 2, but must be in [0.1, 1]");
}

}  // namespace
}  // namespace semantic_slam
