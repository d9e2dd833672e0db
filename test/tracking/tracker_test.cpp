#include "semantic_slam/tracking/tracker.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr double kImagesPerS = 15.0;

Stamp StampOf(int image) {
  return {1'000'000'000'000 + static_cast<std::int64_t>(1e9 * image / kImagesPerS)};
}

// HandheldPath when it is at its fastest, 30 images/s shown as 15: 0.02 m from image to image.
Rigid3d TruePose(int image) {
  return HandheldPath::T_world_camera(3.0 + image / (2.0 * kImagesPerS));
}

// Rendered once for all tests.
std::shared_ptr<const FrameFeatures> RoomFrame(int image) {
  static std::map<int, std::shared_ptr<const FrameFeatures>> frames;
  auto& frame = frames[image];
  if (frame == nullptr) frame = SmallRoomFeatures(TruePose(image), StampOf(image));
  return frame;
}

std::shared_ptr<const FrameFeatures> BlankFrame(int image) {
  return std::make_shared<const FrameFeatures>(BlankImage(StampOf(image)), *SmallCamera(),
                                               SmallExtractor());
}

// The room from the first image's place, looking back to where no keyframe has been.
std::shared_ptr<const FrameFeatures> FrameLookingBack(int image) {
  return SmallRoomFeatures(TruePose(0) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY()),
                           StampOf(image));
}

// Moves everything in the map, as closing a loop would.
void MoveMap(const Rigid3d& T_new_old, Map& map) {
  std::set<PointId> points;
  for (const auto& [id, unused] : map.keyframes()) {
    Keyframe& keyframe = *map.FindKeyframe(id);
    keyframe.T_map_camera = T_new_old * keyframe.T_map_camera;
    points.insert(keyframe.points.begin(), keyframe.points.end());
  }
  points.erase(kNoPoint);
  for (const PointId id : points) {
    map.FindPoint(id)->position = T_new_old * map.FindPoint(id)->position;
  }
  for (const PointId id : points) map.UpdatePointGeometry(id);
}

class TrackerTest : public testing::Test {
 protected:
  TrackerTest() { Use(Options()); }

  static TrackerOptions Options() {
    TrackerOptions options;
    options.max_keyframe_gap = 4;
    return options;
  }

  void Use(const TrackerOptions& options) {
    map_ = std::make_unique<Map>(SmallExtractor().scales());
    tracker_ = std::make_unique<Tracker>(options, ReadoutOptions(), SmallCamera(), *map_, index_);
    tracker_->SetStart(TruePose(0));  // so that the map's frame is the room's
  }

  TrackerResult Track(const std::shared_ptr<const FrameFeatures>& frame,
                      bool keyframe_allowed = true) {
    return tracker_->Track(frame, keyframe_allowed);
  }

  void TrackRoom(int images) {
    for (int i = 0; i < images; ++i) {
      ASSERT_EQ(Track(RoomFrame(i)).image.status, TrackingStatus::kTracking) << i;
    }
  }

  // A centimetre and half a degree: two pixels of this camera.
  static void ExpectNear(const Rigid3d& T, const Rigid3d& T_expected, const std::string& where) {
    EXPECT_LT(DistanceBetween(T, T_expected), 0.01) << where;
    EXPECT_LT(AngleBetween(T, T_expected), 0.5 * M_PI / 180.0) << where;
  }

  const PlaceIndex index_{PlaceIndexOptions()};  // knows nothing: keyframes are tried by turns
  std::unique_ptr<Map> map_;
  std::unique_ptr<Tracker> tracker_;
};

TEST_F(TrackerTest, WaitsForAnImageToStartWith) {
  const TrackerResult blank = Track(BlankFrame(0));
  EXPECT_EQ(blank.image.status, TrackingStatus::kInitializing);
  EXPECT_EQ(blank.image.stamp, StampOf(0));
  EXPECT_FALSE(blank.new_keyframe);
  EXPECT_TRUE(map_->keyframes().empty());

  const TrackerResult first = Track(RoomFrame(1));
  EXPECT_EQ(first.image.status, TrackingStatus::kTracking);
  EXPECT_EQ(first.new_keyframe, 0);
  EXPECT_TRUE(first.image.is_keyframe);
  EXPECT_EQ(first.image.keyframe_id, 0);
  EXPECT_EQ(first.image.T_map_camera.matrix(), TruePose(0).matrix());  // where SetStart() said
  EXPECT_EQ(first.image.T_odom_camera.matrix(), TruePose(0).matrix());
  EXPECT_GT(map_->point_count(), 200u);
}

TEST_F(TrackerTest, AnImageWithoutDepthStartsNoMap) {
  RgbdImage image = SmallRoomImage(TruePose(0), StampOf(0));
  image.depth_m.setTo(0.0f);
  const auto frame = std::make_shared<const FrameFeatures>(image, *SmallCamera(), SmallExtractor());
  EXPECT_EQ(Track(frame).image.status, TrackingStatus::kInitializing);
}

TEST_F(TrackerTest, FollowsTheCamera) {
  for (int i = 0; i < 12; ++i) {
    const TrackerResult result = Track(RoomFrame(i));
    const TrackedImage& image = result.image;
    const std::string where = "image " + std::to_string(i);
    ASSERT_EQ(image.status, TrackingStatus::kTracking) << where;
    EXPECT_EQ(image.stamp, StampOf(i)) << where;
    ExpectNear(image.T_map_camera, TruePose(i), where);
    ExpectNear(image.T_odom_camera, TruePose(i), where);
    EXPECT_TRUE((map_->KeyframePose(image.keyframe_id) * image.T_keyframe_camera)
                    .isApprox(image.T_map_camera, 1e-9))
        << where;
    EXPECT_EQ(image.is_keyframe, result.new_keyframe.has_value()) << where;
    EXPECT_EQ(result.is_inlier.size(), RoomFrame(i)->size()) << where;
    if (!image.is_keyframe) {
      EXPECT_EQ(std::count(result.is_inlier.begin(), result.is_inlier.end(), true), image.inliers)
          << where;
    }
  }
  EXPECT_LT(DistanceBetween(TruePose(0), TruePose(11)), 0.5);
  EXPECT_GT(DistanceBetween(TruePose(0), TruePose(11)), 0.05) << "nothing to follow";
}

TEST_F(TrackerTest, MakesKeyframesAtLeastAsOftenAsTold) {
  int since_keyframe = 0;
  for (int i = 0; i < 12; ++i) {
    since_keyframe = Track(RoomFrame(i)).new_keyframe ? 0 : since_keyframe + 1;
    EXPECT_LT(since_keyframe, 4) << i;
  }
  for (const auto& [id, keyframe] : map_->keyframes()) {
    EXPECT_EQ(keyframe->parent == kNoKeyframe, id == 0);
  }
}

TEST_F(TrackerTest, AsksAgainForAKeyframeThatWasNotAllowed) {
  TrackRoom(1);
  bool rejected = false;
  for (int i = 1; i < 6; ++i) {
    const TrackerResult result = Track(RoomFrame(i), false);
    EXPECT_FALSE(result.new_keyframe);
    rejected = result.keyframe_rejected;
  }
  EXPECT_TRUE(rejected);
  const TrackerResult allowed = Track(RoomFrame(6), true);
  EXPECT_TRUE(allowed.new_keyframe);
  EXPECT_FALSE(allowed.keyframe_rejected);
}

TEST_F(TrackerTest, IsLostOnABlankImageAndFindsItselfAgain) {
  TrackRoom(6);
  const TrackerResult lost = Track(BlankFrame(6));
  EXPECT_EQ(lost.image.status, TrackingStatus::kLost);
  EXPECT_EQ(lost.image.inliers, 0);
  EXPECT_FALSE(lost.new_keyframe);
  EXPECT_EQ(Track(BlankFrame(7)).image.status, TrackingStatus::kLost);

  const TrackerResult found = Track(RoomFrame(8));
  ASSERT_EQ(found.image.status, TrackingStatus::kTracking);
  ExpectNear(found.image.T_map_camera, TruePose(8), "map");
  ExpectNear(found.image.T_odom_camera, TruePose(8), "odom");  // it has not started anew
  EXPECT_EQ(Track(RoomFrame(9)).image.status, TrackingStatus::kTracking);
  EXPECT_EQ(map_->map_id(), 0);
}

TEST_F(TrackerTest, StaysLostWhereItHasNeverBeen) {
  TrackRoom(3);
  EXPECT_EQ(Track(BlankFrame(3)).image.status, TrackingStatus::kLost);
  const std::size_t keyframes = map_->keyframes().size();
  for (int i = 4; i < 7; ++i) {
    EXPECT_EQ(Track(FrameLookingBack(i)).image.status, TrackingStatus::kLost) << i;
  }
  EXPECT_EQ(map_->keyframes().size(), keyframes);
  EXPECT_EQ(Track(RoomFrame(7)).image.status, TrackingStatus::kTracking);
}

TEST_F(TrackerTest, ACameraThatJumpsInsideTheMapIsFound) {
  TrackRoom(12);
  const TrackerResult result = Track(SmallRoomFeatures(TruePose(0), StampOf(12)));
  ASSERT_EQ(result.image.status, TrackingStatus::kTracking);
  ExpectNear(result.image.T_map_camera, TruePose(0), "map");
}

TEST_F(TrackerTest, WhenTheMapJumpsOnlyThePoseInTheMapJumps) {
  TrackRoom(6);
  const Rigid3d T_new_old = Nudged(Rigid3d::Identity(), 0.5, 0.3, 1);
  MoveMap(T_new_old, *map_);
  for (int i = 6; i < 9; ++i) {
    const TrackerResult result = Track(RoomFrame(i));
    const std::string where = "image " + std::to_string(i);
    ASSERT_EQ(result.image.status, TrackingStatus::kTracking) << where;
    ExpectNear(result.image.T_map_camera, T_new_old * TruePose(i), where);
    ExpectNear(result.image.T_odom_camera, TruePose(i), where);
  }
}

TEST_F(TrackerTest, GoesOnWhenItsReferenceKeyframeIsCulled) {
  TrackRoom(6);
  const KeyframeId last = map_->keyframes().rbegin()->first;
  ASSERT_GT(last, 0);
  map_->CullKeyframe(last);
  for (int i = 6; i < 9; ++i) {
    const TrackerResult result = Track(RoomFrame(i));
    ASSERT_EQ(result.image.status, TrackingStatus::kTracking) << i;
    EXPECT_NE(result.image.keyframe_id, last);
    ExpectNear(result.image.T_map_camera, TruePose(i), "image " + std::to_string(i));
  }
}

TEST_F(TrackerTest, ResetStartsANewMap) {
  TrackRoom(6);
  const KeyframeId last = map_->keyframes().rbegin()->first;
  map_->Clear();
  tracker_->Reset(SmallCamera());
  tracker_->SetStart(TruePose(6));
  EXPECT_EQ(Track(BlankFrame(5)).image.status, TrackingStatus::kInitializing);
  const TrackerResult first = Track(RoomFrame(6));
  EXPECT_EQ(first.image.status, TrackingStatus::kTracking);
  EXPECT_EQ(first.image.map_id, 1);
  EXPECT_EQ(first.new_keyframe, last + 1);
  EXPECT_EQ(first.image.T_odom_camera.matrix(), TruePose(6).matrix());
  const TrackerResult second = Track(RoomFrame(7));
  ASSERT_EQ(second.image.status, TrackingStatus::kTracking);
  ExpectNear(second.image.T_map_camera, TruePose(7), "map");
}

TEST_F(TrackerTest, StartedLostItFindsItselfAndOdomGoesOn) {
  TrackRoom(6);
  tracker_->StartLost();
  EXPECT_EQ(Track(BlankFrame(6)).image.status, TrackingStatus::kLost);
  const TrackerResult found = Track(SmallRoomFeatures(TruePose(2), StampOf(7)));
  ASSERT_EQ(found.image.status, TrackingStatus::kTracking);
  ExpectNear(found.image.T_map_camera, TruePose(2), "map");
  ExpectNear(found.image.T_odom_camera, TruePose(5), "odom");  // where it was seen last
}

TEST_F(TrackerTest, StartedLostInAMapThatItHasNotMadeOdomBeginsAtTheStart) {
  TrackRoom(6);
  Tracker other(Options(), ReadoutOptions(), SmallCamera(), *map_, index_);
  other.SetStart(TruePose(0));
  other.StartLost();
  const TrackerResult found = other.Track(RoomFrame(4), true);
  ASSERT_EQ(found.image.status, TrackingStatus::kTracking);
  ExpectNear(found.image.T_map_camera, TruePose(4), "map");
  EXPECT_EQ(found.image.T_odom_camera.matrix(), TruePose(0).matrix());
  ASSERT_EQ(other.Track(RoomFrame(5), true).image.status, TrackingStatus::kTracking);
}

TEST_F(TrackerTest, StartedLostInAnUnknownPlaceItBeginsAMapAtTheStart) {
  TrackRoom(3);
  Tracker other(Options(), ReadoutOptions(), SmallCamera(), *map_, index_);
  other.SetStart(TruePose(1));
  other.StartLost();
  TrackerResult result;
  const int images = static_cast<int>(Options().new_map_after_s * kImagesPerS) + 2;
  for (int i = 3; i < 3 + images; ++i) result = other.Track(FrameLookingBack(i), true);
  ASSERT_EQ(result.image.status, TrackingStatus::kTracking);
  EXPECT_EQ(result.image.map_id, 1);
  ExpectNear(result.image.T_map_camera, TruePose(1), "map");
}

TEST_F(TrackerTest, WithoutMappingTheMapStaysAsItIs) {
  TrackRoom(6);
  const std::uint64_t revision = map_->revision();
  tracker_->SetMapping(false);
  for (int i = 6; i < 12; ++i) {
    const TrackerResult result = Track(RoomFrame(i));
    ASSERT_EQ(result.image.status, TrackingStatus::kTracking) << i;
    EXPECT_FALSE(result.new_keyframe) << i;
    EXPECT_FALSE(result.keyframe_rejected) << i;
    EXPECT_NE(map_->FindKeyframe(result.image.keyframe_id), nullptr) << i;
    ExpectNear(result.image.T_map_camera, TruePose(i), "image " + std::to_string(i));
  }
  const int for_long = 12 + 2 * static_cast<int>(Options().new_map_after_s * kImagesPerS);
  for (int i = 12; i < for_long; ++i) {
    ASSERT_EQ(Track(FrameLookingBack(i)).image.status, TrackingStatus::kLost) << i;
  }
  EXPECT_EQ(map_->revision(), revision);

  tracker_->SetMapping(true);
  // It begins to wait now, whatever it has seen before.
  EXPECT_EQ(Track(FrameLookingBack(for_long)).image.status, TrackingStatus::kLost);
  const TrackerResult found = Track(SmallRoomFeatures(TruePose(8), StampOf(for_long + 1)));
  ASSERT_EQ(found.image.status, TrackingStatus::kTracking);
  EXPECT_TRUE(found.new_keyframe);
}

TEST_F(TrackerTest, WithoutMappingNoMapBegins) {
  tracker_->SetMapping(false);
  EXPECT_EQ(Track(RoomFrame(0)).image.status, TrackingStatus::kInitializing);
  tracker_->SetMapping(true);
  EXPECT_EQ(Track(RoomFrame(1)).image.status, TrackingStatus::kTracking);
}

// Everything in the left half of the image is of a class that is to be left out.
LabelImage LeftHalf(Stamp stamp) {
  LabelImage image{stamp, cv::Mat(240, 320, CV_8UC1, cv::Scalar::all(1)), {31}};
  image.labels.colRange(0, 160) = cv::Scalar::all(31);
  return image;
}

TEST_F(TrackerTest, WhatLabelsLeaveOutHasNoPartInPoseOrMap) {
  for (int i = 0; i < 6; ++i) {
    ASSERT_EQ(tracker_->AddLabels(LeftHalf(StampOf(i))), LabelImageFate::kUsed);
    const TrackerResult result = Track(RoomFrame(i));
    ASSERT_EQ(result.image.status, TrackingStatus::kTracking);
    ExpectNear(result.image.T_map_camera, TruePose(i), "image " + std::to_string(i));
    for (std::size_t k = 0; k < result.moves.size(); ++k) {
      const bool in_half = (*RoomFrame(i))[k].raw.x() < 159.0f;
      EXPECT_TRUE(result.moves[k] || !in_half) << i;
      EXPECT_FALSE(result.moves[k] && result.is_inlier[k]) << i;
    }
  }
  for (const auto& [id, keyframe] : map_->keyframes()) {
    for (std::size_t k = 0; k < keyframe->points.size(); ++k) {
      if (keyframe->points[k] == kNoPoint) continue;
      EXPECT_GT((*keyframe->features)[k].raw.x(), 159.0f) << id;
    }
  }
}

TEST_F(TrackerTest, LabelsOfTheLastImagesAreUsedWhereTheyAreNow) {
  TrackRoom(3);
  ASSERT_EQ(tracker_->AddLabels(LeftHalf(StampOf(1))), LabelImageFate::kUsed);
  const TrackerResult result = Track(RoomFrame(3));
  const auto left_out = std::count(result.moves.begin(), result.moves.end(), true);
  EXPECT_GT(left_out, 0.2 * static_cast<double>(result.moves.size()));
  EXPECT_EQ(tracker_->AddLabels(LeftHalf(StampOf(0))), LabelImageFate::kOutOfOrder);
  LabelImage small = LeftHalf(StampOf(3));
  small.labels = small.labels.rowRange(0, 100);
  EXPECT_EQ(tracker_->AddLabels(small), LabelImageFate::kBadSize);
}

TEST_F(TrackerTest, InARoomThatStandsStillNothingIsLeftOut) {
  for (int i = 0; i < 12; ++i) {
    const TrackerResult result = Track(RoomFrame(i));
    EXPECT_EQ(std::count(result.moves.begin(), result.moves.end(), true), 0) << i;
  }
}

TEST_F(TrackerTest, TellsHowSureThePoseIs) {
  const Matrix6d unknown = UnknownPoseCovariance();
  EXPECT_EQ(Track(BlankFrame(0)).image.covariance, unknown);
  const Matrix6d first = Track(RoomFrame(1)).image.covariance;
  EXPECT_LT(first(0, 0), 2e-6) << "it is where the map begins by definition";
  const Matrix6d tracked = Track(RoomFrame(2)).image.covariance;
  EXPECT_GT(tracked(0, 0), 1e-6);
  EXPECT_LT((tracked.topLeftCorner<3, 3>().trace()), 1e-3);  // 3 cm: a room 2 m away, 1 px
  EXPECT_EQ(Track(BlankFrame(3)).image.covariance, unknown);
}

TEST_F(TrackerTest, TheSameImagesGiveTheSameBytes) {
  std::vector<TrackedImage> first;
  for (int i = 0; i < 8; ++i) first.push_back(Track(RoomFrame(i)).image);
  Use(Options());
  for (int i = 0; i < 8; ++i) {
    const TrackedImage again = Track(RoomFrame(i)).image;
    EXPECT_EQ(again.T_map_camera.matrix(), first[i].T_map_camera.matrix()) << i;
    EXPECT_EQ(again.T_odom_camera.matrix(), first[i].T_odom_camera.matrix()) << i;
    EXPECT_EQ(again.inliers, first[i].inliers) << i;
  }
}

TEST_F(TrackerTest, RefusesOptionsOutOfRange) {
  TrackerOptions options;
  options.min_inliers = 5;
  EXPECT_EQ(MessageOf<ConfigError>(
                [&] { Tracker(options, ReadoutOptions(), SmallCamera(), *map_, index_); }),
            "min_inliers = 5, but must be in [6, 1000]");
}

}  // namespace
}  // namespace semantic_slam
