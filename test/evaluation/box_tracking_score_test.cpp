#include "semantic_slam/evaluation/box_tracking_score.h"

#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "semantic_slam/common/error.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

using Boxes = std::vector<BoxInFrame>;

// Two objects that stand still for ten frames.
Boxes TwoObjects() {
  Boxes boxes;
  for (int frame = 1; frame <= 10; ++frame) {
    boxes.push_back({frame, 1, {0, 0, 10, 20}});
    boxes.push_back({frame, 2, {100, 0, 10, 20}});
  }
  return boxes;
}

TEST(BoxTrackingScoreTest, ThePerfectTrackerScoresOneWhateverItsIds) {
  Boxes estimate = TwoObjects();
  for (BoxInFrame& box : estimate) box.id = 50 - box.id;
  const BoxTrackingScore score = ScoreBoxTracks(TwoObjects(), estimate);
  EXPECT_DOUBLE_EQ(score.mota, 1.0);
  EXPECT_DOUBLE_EQ(score.idf1, 1.0);
  EXPECT_DOUBLE_EQ(score.hota, 1.0);
  EXPECT_EQ(score.id_switches, 0u);
}

TEST(BoxTrackingScoreTest, NoTrackerScoresZero) {
  const BoxTrackingScore score = ScoreBoxTracks(TwoObjects(), {});
  EXPECT_DOUBLE_EQ(score.mota, 0.0);
  EXPECT_DOUBLE_EQ(score.idf1, 0.0);
  EXPECT_DOUBLE_EQ(score.hota, 0.0);
  EXPECT_EQ(score.false_negatives, 20u);
}

TEST(BoxTrackingScoreTest, OneSwitchAndOneFalseAlarm) {
  Boxes estimate = TwoObjects();
  for (BoxInFrame& box : estimate) {
    if (box.id == 1 && box.frame > 5) box.id = 3;
  }
  estimate.push_back({10, 9, {500, 500, 10, 10}});
  const BoxTrackingScore score = ScoreBoxTracks(TwoObjects(), estimate);
  EXPECT_EQ(score.id_switches, 1u);
  EXPECT_EQ(score.false_positives, 1u);
  EXPECT_EQ(score.false_negatives, 0u);
  EXPECT_DOUBLE_EQ(score.mota, 1.0 - 2.0 / 20.0);
  // 15 of 20 boxes keep the id that suits most; 2 * 15 / (20 + 21).
  EXPECT_DOUBLE_EQ(score.idf1, 30.0 / 41.0);
  // DetA 20/21; AssA: ten boxes with 1, ten with 5/10.
  EXPECT_NEAR(score.hota, std::sqrt(20.0 / 21.0 * 0.75), 1e-12);
}

TEST(BoxTrackingScoreTest, AShiftedBoxCountsUpToItsOverlap) {
  Boxes estimate = TwoObjects();
  for (BoxInFrame& box : estimate) box.box.y += 10.0 / 3.0;  // IoU (20 - 10/3) / (20 + 10/3) = 5/7
  const BoxTrackingScore score = ScoreBoxTracks(TwoObjects(), estimate);
  EXPECT_DOUBLE_EQ(score.mota, 1.0);
  EXPECT_DOUBLE_EQ(score.hota, 14.0 / 19.0);  // of 0.05 ... 0.70, fourteen thresholds
}

TEST(BoxTrackingScoreTest, AMatchOfTheFrameBeforeIsKept) {
  // In frame 2 the other object's box fits better, but both still match.
  const Boxes reference{{1, 1, {0, 0, 10, 20}}, {2, 1, {0, 0, 10, 20}}};
  const Boxes estimate{{1, 5, {0, 0, 10, 20}}, {2, 5, {0, 4, 10, 20}}, {2, 6, {0, 0, 10, 20}}};
  const BoxTrackingScore score = ScoreBoxTracks(reference, estimate);
  EXPECT_EQ(score.id_switches, 0u);
  EXPECT_EQ(score.false_positives, 1u);
}

TEST(BoxTrackingScoreTest, ReferenceBoxesMarkedWithZeroDoNotCount) {
  Boxes reference = TwoObjects();
  reference.push_back({1, 3, {300, 0, 10, 20}, 0.0});
  EXPECT_EQ(ScoreBoxTracks(reference, TwoObjects()).reference_boxes, 20u);
}

TEST(BoxTrackingScoreTest, WhatCannotBeScoredIsRefused) {
  ExpectOneLineWith(MessageOf<InputError>([] { ScoreBoxTracks({}, TwoObjects()); }), {"reference"});
  Boxes twice = TwoObjects();
  twice.push_back(twice.back());
  ExpectOneLineWith(MessageOf<InputError>([&] { ScoreBoxTracks(TwoObjects(), twice); }),
                    {"estimate", "id 2", "frame 10"});
}

TEST(BoxTrackingScoreTest, ReportsInPercent) {
  const BoxTrackingScore score = ScoreBoxTracks(TwoObjects(), TwoObjects());
  EXPECT_DOUBLE_EQ(ToJson(score)["mota"], 100.0);
  EXPECT_EQ(ToJson(score)["id_switches"], 0);
  std::ostringstream table;
  PrintTable(score, table);
  EXPECT_NE(table.str().find("IDF1             100.0 %"), std::string::npos) << table.str();
}

}  // namespace
}  // namespace semantic_slam
