#include "semantic_slam/object_tracking/object_tracker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "semantic_slam/common/error.h"
#include "semantic_slam/evaluation/box_tracking_score.h"
#include "testing/expect_error.h"
#include "testing/shared_data.h"

namespace semantic_slam {
namespace {

constexpr LabelId kChair = 1, kTable = 2;

std::shared_ptr<const LabelVocabulary> Vocabulary() {
  LabelClass unknown, chair, table;
  unknown.name = "unknown";
  chair.id = kChair;
  chair.name = "chair";
  table.id = kTable;
  table.name = "table";
  return std::make_shared<const LabelVocabulary>(std::vector<LabelClass>{unknown, chair, table});
}

Stamp At(int image) {
  return Stamp{(image + 1) * 100'000'000LL};
}

Detections Found(int image, std::vector<DetectedBox> boxes) {
  return {At(image), Vocabulary()->hash(), {640, 480}, std::move(boxes)};
}

// The paper's thresholds, whatever the defaults are.
ObjectTrackerOptions PaperOptions() {
  ObjectTrackerOptions options;
  options.high_confidence = 0.6;
  options.low_confidence = 0.1;
  options.new_confidence = 0.7;
  return options;
}

ObjectTracker MakeTracker(const ObjectTrackerOptions& options = PaperOptions()) {
  ObjectTrackingOptions all;
  all.tracker = options;
  return ObjectTracker(all, Vocabulary());
}

DetectedBox Moved(DetectedBox box, float dx, float dy = 0.0f) {
  box.box.x += dx;
  box.box.y += dy;
  return box;
}

DetectedBox With(DetectedBox box, float confidence) {
  box.confidence = confidence;
  return box;
}

const DetectedBox kBox{kChair, 0.9f, {100, 100, 80, 120}};
const DetectedBox kOther{kChair, 0.9f, {400, 200, 50, 50}};

TEST(ObjectTrackerTest, ABoxIsBelievedAtOnceInTheFirstImageAndLaterWhenSeenTwice) {
  ObjectTracker tracker = MakeTracker();
  EXPECT_EQ(tracker.Update(Found(0, {kBox}), {}).tracks.at(0).state, TrackState::kConfirmed);
  const ObjectTracks second = tracker.Update(Found(1, {kBox, kOther}), {});
  ASSERT_EQ(second.tracks.size(), 2u);
  EXPECT_EQ(second.tracks[1].state, TrackState::kTentative);
  const ObjectTracks third = tracker.Update(Found(2, {kBox, kOther}), {});
  EXPECT_EQ(third.tracks.at(1).state, TrackState::kConfirmed);
  EXPECT_EQ(third.tracks.at(1).hits, 2);
  EXPECT_EQ(third.stamp, At(2));
  EXPECT_EQ(third.vocabulary_hash, Vocabulary()->hash());
  EXPECT_EQ(third.image_size, cv::Size(640, 480));
}

TEST(ObjectTrackerTest, ATentativeTrackThatIsNotSeenAgainEnds) {
  ObjectTracker tracker = MakeTracker();
  tracker.Update(Found(0, {kBox}), {});
  tracker.Update(Found(1, {kBox, kOther}), {});
  const ObjectTracks third = tracker.Update(Found(2, {kBox}), {});
  ASSERT_EQ(third.tracks.size(), 1u);
  const ObjectTracks fifth =
      (tracker.Update(Found(3, {kBox, kOther}), {}), tracker.Update(Found(4, {kBox, kOther}), {}));
  EXPECT_EQ(fifth.tracks.at(1).id, third.tracks[0].id + 2);  // never the old id again
}

TEST(ObjectTrackerTest, IdsFollowBoxesThatMove) {
  ObjectTracker tracker = MakeTracker();
  const ObjectTracks first = tracker.Update(Found(0, {kBox, kOther}), {});
  for (int i = 1; i < 10; ++i) {
    const auto dx = static_cast<float>(12 * i);
    const ObjectTracks next =
        tracker.Update(Found(i, {Moved(kOther, -dx / 2), Moved(kBox, dx)}), {});
    ASSERT_EQ(next.tracks.size(), 2u) << i;
    EXPECT_EQ(next.tracks[0].id, first.tracks[0].id);
    // The filter lags behind a box that starts to move at once, by less than its step.
    EXPECT_NEAR(next.tracks[0].detection.box.x, 100.0f + dx, 12.0f) << i;
  }
}

TEST(ObjectTrackerTest, TwoThatCrossKeepTheirIds) {
  ObjectTracker tracker = MakeTracker();
  // Of one class, 60 px apart in height of 120: they overlap by a third when they meet.
  const DetectedBox right{kChair, 0.9f, {100, 100, 80, 120}},
      left{kChair, 0.9f, {400, 180, 80, 120}};
  std::vector<TrackId> ids;
  for (int i = 0; i <= 30; ++i) {
    const auto dx = static_cast<float>(10 * i);
    const ObjectTracks now = tracker.Update(Found(i, {Moved(right, dx), Moved(left, -dx)}), {});
    ASSERT_EQ(now.tracks.size(), 2u) << i;
    const bool first_is_right = now.tracks[0].detection.box.y < 140.0f;
    ids.push_back(now.tracks[first_is_right ? 0 : 1].id);
  }
  EXPECT_EQ(std::count(ids.begin(), ids.end(), ids.front()), 31);
}

TEST(ObjectTrackerTest, UnsureBoxesKeepATrackButDoNotBeginOne) {
  ObjectTracker tracker = MakeTracker();
  tracker.Update(Found(0, {kBox}), {});
  const ObjectTracks second =
      tracker.Update(Found(1, {With(kOther, 0.65f), With(Moved(kBox, 4), 0.3f)}), {});
  ASSERT_EQ(second.tracks.size(), 1u);
  EXPECT_EQ(second.tracks[0].state, TrackState::kConfirmed);
  EXPECT_FLOAT_EQ(second.tracks[0].detection.confidence, 0.3f);
  const ObjectTracks third = tracker.Update(Found(2, {With(kBox, 0.05f)}), {});
  EXPECT_EQ(third.tracks.at(0).state, TrackState::kLost);
}

TEST(ObjectTrackerTest, ALostTrackIsFoundAgainWithItsId) {
  ObjectTracker tracker = MakeTracker();
  const TrackId id = tracker.Update(Found(0, {kBox}), {}).tracks.at(0).id;
  for (int i = 1; i <= 5; ++i) {
    const ObjectTracks lost = tracker.Update(Found(i, {}), {});
    ASSERT_EQ(lost.tracks.size(), 1u);
    EXPECT_EQ(lost.tracks[0].state, TrackState::kLost);
    EXPECT_NEAR(lost.tracks[0].since_seen_s, 0.1 * i, 1e-9);  // a stamp is exact, a double nearly
  }
  const ObjectTracks found = tracker.Update(Found(6, {kBox}), {});
  ASSERT_EQ(found.tracks.size(), 1u);
  EXPECT_EQ(found.tracks[0].id, id);
  EXPECT_EQ(found.tracks[0].state, TrackState::kConfirmed);
  EXPECT_EQ(found.tracks[0].hits, 2);
}

TEST(ObjectTrackerTest, ALostTrackEndsAfterItsImagesOrItsTime) {
  ObjectTrackerOptions options = PaperOptions();
  options.max_lost_images = 3;
  options.max_lost_s = 100.0;
  ObjectTracker by_images = MakeTracker(options);
  by_images.Update(Found(0, {kBox}), {});
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(by_images.Update(Found(i, {}), {}).tracks.size(), 1u) << i;
  EXPECT_TRUE(by_images.Update(Found(5, {}), {}).tracks.empty());

  options.max_lost_images = 100;
  options.max_lost_s = 0.45;
  ObjectTracker by_time = MakeTracker(options);
  by_time.Update(Found(0, {kBox}), {});
  EXPECT_EQ(by_time.Update(Found(4, {}), {}).tracks.size(), 1u);
  EXPECT_TRUE(by_time.Update(Found(5, {}), {}).tracks.empty());
}

TEST(ObjectTrackerTest, AfterAPauseOfTheDetectorBoxesBeginNewTracks) {
  ObjectTracker tracker = MakeTracker();
  const TrackId id = tracker.Update(Found(0, {kBox}), {}).tracks.at(0).id;
  const ObjectTracks later = tracker.Update(Found(600, {kBox}), {});
  ASSERT_EQ(later.tracks.size(), 1u);
  EXPECT_GT(later.tracks[0].id, id);
}

TEST(ObjectTrackerTest, ClassesAreKeptApartUnlessTheOptionSaysOtherwise) {
  DetectedBox as_table = kBox;
  as_table.label = kTable;
  ObjectTracker apart = MakeTracker();
  apart.Update(Found(0, {kBox}), {});
  EXPECT_EQ(apart.Update(Found(1, {as_table}), {}).tracks.size(), 2u);

  ObjectTrackerOptions options = PaperOptions();
  options.same_label_only = false;
  ObjectTracker together = MakeTracker(options);
  together.Update(Found(0, {kBox}), {});
  const ObjectTracks second = together.Update(Found(1, {as_table}), {});
  ASSERT_EQ(second.tracks.size(), 1u);
  EXPECT_EQ(second.tracks[0].detection.label, kTable);
}

TEST(ObjectTrackerTest, OfTwoTracksAtOnePlaceTheYoungerGoes) {
  ObjectTracker tracker = MakeTracker();
  const TrackId id = tracker.Update(Found(0, {kBox}), {}).tracks.at(0).id;
  for (int i = 1; i < 5; ++i) tracker.Update(Found(i, {kBox}), {});
  // The box leaves too fast to be followed and begins a new track, which comes back to where the
  // old one was lost.
  tracker.Update(Found(5, {Moved(kBox, 204)}), {});
  tracker.Update(Found(6, {Moved(kBox, 204)}), {});
  ObjectTracks now = tracker.Update(Found(7, {Moved(kBox, 204)}), {});
  ASSERT_EQ(now.tracks.size(), 2u);
  // It comes back by 20 px an image and stops 4 px off, where its own track fits better still.
  for (int i = 1; i <= 10; ++i) {
    now = tracker.Update(Found(7 + i, {Moved(kBox, static_cast<float>(204 - 20 * i))}), {});
  }
  ASSERT_EQ(now.tracks.size(), 1u);
  EXPECT_NE(now.tracks[0].state, TrackState::kLost);
  EXPECT_GT(now.tracks[0].id, id);  // followed for longer by then
}

TEST(ObjectTrackerTest, TheCamerasMotionIsTakenOutOfThePrediction) {
  cv::Mat wide(480, 840, CV_8UC3);
  cv::RNG(1).fill(wide, cv::RNG::UNIFORM, 0, 255);
  cv::resize(wide(cv::Rect(0, 0, 105, 60)), wide, wide.size(), 0, 0, cv::INTER_CUBIC);
  const auto seen = [&](int shift) { return wide(cv::Rect(shift, 0, 640, 480)).clone(); };
  // The camera turns by 35 px: more than half of the box's width of 50 px.
  const auto id_after_shift = [&](bool compensate) {
    ObjectTrackerOptions options = PaperOptions();
    options.compensate_camera = compensate;
    ObjectTracker tracker = MakeTracker(options);
    const TrackId before = tracker.Update(Found(0, {kOther}), seen(0)).tracks.at(0).id;
    const ObjectTracks after = tracker.Update(Found(1, {Moved(kOther, -45.0f)}), seen(45));
    return std::make_pair(before, after.tracks.back().id);
  };
  const auto [before, after] = id_after_shift(true);
  EXPECT_EQ(before, after);
  const auto [before_without, after_without] = id_after_shift(false);
  EXPECT_NE(before_without, after_without);
}

TEST(ObjectTrackerTest, AJumpBackOrAnotherImageSizeBeginsAnewWithNewIds) {
  ObjectTracker tracker = MakeTracker();
  const TrackId first = tracker.Update(Found(100, {kBox}), {}).tracks.at(0).id;
  const ObjectTracks after_jump = tracker.Update(Found(0, {kBox}), {});
  ASSERT_EQ(after_jump.tracks.size(), 1u);
  EXPECT_GT(after_jump.tracks[0].id, first);
  EXPECT_EQ(after_jump.tracks[0].state, TrackState::kConfirmed);  // a first image again

  Detections small = Found(1, {kBox});
  small.image_size = {320, 240};
  const ObjectTracks after_size = tracker.Update(small, {});
  ASSERT_EQ(after_size.tracks.size(), 1u);
  EXPECT_GT(after_size.tracks[0].id, after_jump.tracks[0].id);
}

TEST(ObjectTrackerTest, WhatIsOutOfOrderIsRefusedAndChangesNothing) {
  ObjectTracker tracker = MakeTracker();
  tracker.Update(Found(5, {kBox}), {});
  for (const int image : {5, 3}) {
    ExpectOneLineWith(MessageOf<InputError>([&] { tracker.Update(Found(image, {kOther}), {}); }),
                      {"stamp", "0.600000"});
  }
  EXPECT_EQ(tracker.Update(Found(6, {kBox}), {}).tracks.size(), 1u);
}

TEST(ObjectTrackerTest, MalformedInputIsRefusedInOneLine) {
  ObjectTracker tracker = MakeTracker();
  const auto message = [&](const Detections& detections, const cv::Mat& image = {}) {
    return MessageOf<InputError>([&] { tracker.Update(detections, image); });
  };
  Detections other_labels = Found(0, {kBox});
  ++other_labels.vocabulary_hash;
  ExpectOneLineWith(message(other_labels), {"label set"});
  DetectedBox unknown = kBox;
  unknown.label = 77;
  ExpectOneLineWith(message(Found(0, {unknown})), {"77"});
  DetectedBox nan = kBox;
  nan.box.x = std::numeric_limits<float>::quiet_NaN();
  ExpectOneLineWith(message(Found(0, {nan})), {"box"});
  Detections no_size = Found(0, {kBox});
  no_size.image_size = {};
  ExpectOneLineWith(message(no_size), {"image size"});
  ExpectOneLineWith(message(Found(0, {kBox}), cv::Mat(10, 10, CV_8UC3)), {"10 x 10", "640 x 480"});
  ExpectOneLineWith(message(Found(0, {kBox}), cv::Mat(480, 640, CV_16UC1)), {"CV_16UC1"});
  EXPECT_TRUE(tracker.Update(Found(0, {}), {}).tracks.empty());
}

TEST(ObjectTrackerTest, BoxesOffTheImageAndAbsurdOnesDoNoHarm) {
  ObjectTracker tracker = MakeTracker();
  const DetectedBox off{kChair, 0.9f, {-500, -500, 100, 100}};
  const DetectedBox huge{kChair, 0.9f, {-1e38f, -1e38f, 3e38f, 3e38f}};
  for (int i = 0; i < 50; ++i) {
    const ObjectTracks now = tracker.Update(
        Found(i, i % 3 == 0 ? std::vector<DetectedBox>{huge, off} : std::vector<DetectedBox>{}),
        {});
    EXPECT_LE(now.tracks.size(), 1u);
    for (const ObjectTrack& track : now.tracks) {
      EXPECT_TRUE(std::isfinite(track.detection.box.x + track.detection.box.width));
      EXPECT_GT(track.detection.box.area(), 0.0f);
    }
  }
}

TEST(ObjectTrackerTest, OnlyTheMostConfidentBoxesAreLookedAt) {
  ObjectTrackerOptions options = PaperOptions();
  options.max_boxes = 2;
  ObjectTracker tracker = MakeTracker(options);
  EXPECT_EQ(tracker.Update(Found(0, std::vector<DetectedBox>(50, kBox)), {}).tracks.size(), 2u);
}

TEST(ObjectTrackerTest, OptionsOutOfRangeAreNamed) {
  ObjectTrackingOptions options;
  options.tracker.low_confidence = 0.9;
  ExpectOneLineWith(MessageOf<ConfigError>([&] { ObjectTracker tracker(options, Vocabulary()); }),
                    {"low_confidence"});
}

// The frames of one sequence of the MOTChallenge through the tracker: boxes of confirmed tracks.
std::vector<BoxInFrame> Track(const std::vector<BoxInFrame>& found, cv::Size image_size) {
  ObjectTracker tracker = MakeTracker();
  std::vector<BoxInFrame> tracked;
  std::size_t next = 0;
  for (int frame = 1; frame <= found.back().frame; ++frame) {
    Detections detections = Found(frame, {});
    detections.image_size = image_size;
    for (; next < found.size() && found[next].frame == frame; ++next) {
      const auto confidence = static_cast<float>(std::clamp(found[next].confidence, 0.0, 1.0));
      detections.boxes.push_back({kChair, confidence, cv::Rect2f(found[next].box)});
    }
    for (const ObjectTrack& track : tracker.Update(detections, {}).tracks) {
      if (track.state != TrackState::kConfirmed) continue;
      tracked.push_back({frame, static_cast<int>(track.id), cv::Rect2d(track.detection.box)});
    }
  }
  return tracked;
}

struct Mot15Sequence {
  const char* name;
  cv::Size image_size;
  double mota_percent;  // of the reference implementation, from the same boxes
  double idf1_percent;
};

class Mot15Test : public testing::TestWithParam<Mot15Sequence> {};

TEST_P(Mot15Test, FollowsPedestriansAsWellAsTheReference) {
  const auto folder = SharedData(std::string("data/mot15/") + GetParam().name);
  SEMANTIC_SLAM_SKIP_WITHOUT(folder, "MOT15");
  const auto tracked = Track(ReadBoxTracks(*folder + "/det/det.txt"), GetParam().image_size);
  const BoxTrackingScore score = ScoreBoxTracks(ReadBoxTracks(*folder + "/gt/gt.txt"), tracked);
  // The reference measures boxes as a pixel wider and higher, which turns few pairs in a thousand.
  EXPECT_NEAR(100.0 * score.mota, GetParam().mota_percent, 0.3);
  EXPECT_NEAR(100.0 * score.idf1, GetParam().idf1_percent, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Sequences, Mot15Test,
                         testing::Values(Mot15Sequence{"TUD-Campus", {640, 480}, 64.9, 72.0},
                                         Mot15Sequence{"ETH-Sunnyday", {640, 480}, 58.2, 76.7},
                                         Mot15Sequence{"ETH-Pedcross2", {640, 480}, 45.6, 55.0},
                                         Mot15Sequence{"Venice-2", {1920, 1080}, 18.3, 41.8}));

}  // namespace
}  // namespace semantic_slam
