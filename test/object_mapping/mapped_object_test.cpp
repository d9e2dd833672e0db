#include "semantic_slam/object_mapping/mapped_object.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr LabelId kTable = 1;

LabelVocabulary Vocabulary() {
  LabelClass unknown, table;
  unknown.name = "unknown";
  table.id = kTable;
  table.name = "table";
  table.hollow = true;
  return LabelVocabulary({unknown, table});
}

ObjectObservation Seen(KeyframeId keyframe, double quality, bool complete = true) {
  ObjectObservation seen;
  seen.keyframe_id = keyframe;
  seen.centre = {0.5, 0.5, 0.5};
  seen.covariance_m2 = 0.01 * Eigen::Matrix3d::Identity();
  seen.body = {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
  seen.outline = seen.body;
  seen.lowest = {0.5, 0.5, 0.0};
  seen.highest = {0.5, 0.5, 1.0};
  seen.quality = quality;
  seen.complete = complete;
  return seen;
}

TEST(MappedObjectTest, KeepsTheBestObservationsAndCountsAll) {
  MappedObject object(3, 2);
  for (int i = 0; i < 100; ++i) object.Add(Seen(i, i), {5, 2}, Stamp{i});
  ASSERT_EQ(object.observations().size(), 5u);
  EXPECT_EQ(object.observations()[0].quality, 99.0);
  EXPECT_EQ(object.observations()[4].quality, 95.0);
  EXPECT_EQ(object.images(), 100);
  EXPECT_EQ(object.last_seen(), Stamp{99});
}

TEST(MappedObjectTest, OneKeyframeCannotPushOutTheOthers) {
  MappedObject object(3, 2);
  object.Add(Seen(1, 1.0), {5, 2}, Stamp{1});
  for (int i = 0; i < 100; ++i) object.Add(Seen(2, 10.0 + i), {5, 2}, Stamp{2});
  const auto& kept = object.observations();
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_EQ(kept[0].quality, 109.0);
  EXPECT_EQ(kept[1].quality, 108.0);
  EXPECT_EQ(kept[2].keyframe_id, 1);
}

TEST(MappedObjectTest, AWholeViewIsBetterThanAnyPart) {
  MappedObject object(3, 2);
  for (int i = 0; i < 5; ++i) object.Add(Seen(i, 100.0, false), {5, 2}, Stamp{1});
  object.Add(Seen(9, 1.0, true), {5, 2}, Stamp{1});
  EXPECT_TRUE(object.observations().front().complete);
  EXPECT_EQ(object.observations().size(), 5u);
}

TEST(MappedObjectTest, ReportsEverything) {
  MappedObject object(3, 2);
  ObjectObservation seen = Seen(1, 1.0);
  seen.below.free_columns = 100;
  object.Add(seen, {}, Stamp{5});
  object.AddLabel(kTable, 0.8f);
  object.Place([](KeyframeId) { return Rigid3d(Eigen::Translation3d(1.0, 0.0, 0.0)); });
  const MapObject report = object.Report(Vocabulary(), {});
  EXPECT_EQ(report.id, 3);
  EXPECT_EQ(report.labels.at(0).label, kTable);
  EXPECT_NEAR((report.position_m - Eigen::Vector3d(1.5, 0.5, 0.5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((report.T_map_box.translation() - Eigen::Vector3d(1.5, 0.5, 0.5)).norm(), 0.0, 1e-9);
  EXPECT_NEAR((report.box_size_m - Eigen::Vector3d(1, 1, 1)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(report.min_height_m, 0.0, 1e-9);
  EXPECT_NEAR(report.max_height_m, 1.0, 1e-9);
  EXPECT_EQ(report.hollow, Hollowness::kFull);
  EXPECT_EQ(report.footprint_m.size(), 4u);
  EXPECT_EQ(report.observations, 1);
  EXPECT_EQ(report.last_seen, Stamp{5});
}

TEST(MappedObjectTest, WhatCannotBePlacedStaysWhereItWas) {
  MappedObject object(3, 2);
  object.Add(Seen(1, 1.0), {}, Stamp{5});
  object.Place([](KeyframeId) { return Rigid3d::Identity(); });
  Rigid3d flat = Rigid3d::Identity();
  flat.linear() = Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  object.Place([&](KeyframeId) { return flat; });  // the outline stands upright: no area from above
  EXPECT_NEAR(Area(object.shape().body_m), 1.0, 1e-9);
}

TEST(MappedObjectTest, AbsorbingTakesOverAll) {
  MappedObject a(1, 2), b(2, 2);
  a.Add(Seen(1, 1.0), {}, Stamp{5});
  b.Add(Seen(2, 2.0), {}, Stamp{9});
  b.AddLabel(kTable, 0.8f);
  a.Absorb(b, {});
  EXPECT_EQ(a.id(), 1);
  EXPECT_EQ(a.images(), 2);
  EXPECT_EQ(a.last_seen(), Stamp{9});
  EXPECT_EQ(a.label(), kTable);
  EXPECT_EQ(a.observations().size(), 2u);
}

}  // namespace
}  // namespace semantic_slam
