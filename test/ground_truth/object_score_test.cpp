#include "semantic_slam/ground_truth/object_score.h"

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam/ground_truth/object_truth.h"

namespace semantic_slam {
namespace {

// Two tables and a lamp.
std::vector<MapObject> Truth() {
  const World world =
      MakeWorld({MakeObject(kTable, TableMesh(), At(1.0, 1.0)),
                 MakeObject(kTable, TableMesh(), At(4.0, 1.0, 1.0)),
                 MakeObject(kLamp, CylinderMesh({0, 0, 0}, 0.15f, 0.15f, 1.7f), At(2.5, 2.5))});
  return TrueObjects(world, SmallVocabulary()).objects;
}

MapObject Moved(MapObject object, double dx_m, double dy_m) {
  return InWorld(object, At(dx_m, dy_m));
}

const std::vector<bool> kAll{true, true, true};
const Rigid3d kSame = Rigid3d::Identity();

TEST(ObjectScoreTest, APerfectMapHasNoErrors) {
  const ObjectScore score = ScoreObjects(Truth(), Truth(), kSame, kAll);
  EXPECT_EQ(score.expected, 3u);
  EXPECT_EQ(score.matches.size(), 3u);
  EXPECT_EQ(score.right_class(), 3u);
  EXPECT_TRUE(score.missed.empty());
  EXPECT_TRUE(score.extra.empty());
  EXPECT_EQ(score.position_m().max, 0.0);
  EXPECT_EQ(score.box_m().max, 0.0);
  EXPECT_EQ(score.height_m().max, 0.0);
  EXPECT_EQ(score.size_m().max, 0.0);
}

TEST(ObjectScoreTest, MeasuresErrors) {
  std::vector<MapObject> estimate{Moved(Truth()[0], 0.03, 0.04), Truth()[2]};
  estimate[0].labels = {{kChair, 0.9f}};
  estimate[0].max_height_m += 0.05;
  estimate[0].box_size_m.x() -= 0.1;
  const ObjectScore score = ScoreObjects(Truth(), estimate, kSame, kAll);
  ASSERT_EQ(score.matches.size(), 2u);
  EXPECT_EQ(score.matches[0].truth, 0u);
  EXPECT_FALSE(score.matches[0].right_class);
  EXPECT_NEAR(score.matches[0].position_error_m, 0.05, 1e-9);
  EXPECT_NEAR(score.matches[0].box_error_m, 0.05, 1e-9);
  EXPECT_NEAR(score.matches[0].height_error_m, 0.05, 1e-9);
  EXPECT_NEAR(score.matches[0].size_error_m, 0.05, 1e-9);  // 0.1 and 0
  EXPECT_NEAR(score.position_m().mean, 0.025, 1e-9);
  EXPECT_EQ(score.right_class(), 1u);
  ASSERT_EQ(score.missed.size(), 1u);
  EXPECT_EQ(score.missed[0], 1u);
}

TEST(ObjectScoreTest, WhatIsNotInTheWorldIsExtra) {
  std::vector<MapObject> estimate = Truth();
  estimate.push_back(Moved(Truth()[2], 5.0, 5.0));
  estimate.push_back(Truth()[0]);  // the same table a second time
  const ObjectScore score = ScoreObjects(Truth(), estimate, kSame, kAll);
  EXPECT_EQ(score.matches.size(), 3u);
  EXPECT_EQ(score.extra.size(), 2u);
}

TEST(ObjectScoreTest, WhatWasNotToBeExpectedIsNeitherMissedNorExtra) {
  const ObjectScore found = ScoreObjects(Truth(), Truth(), kSame, {true, false, true});
  EXPECT_EQ(found.expected, 2u);
  EXPECT_EQ(found.matches.size(), 2u);
  EXPECT_TRUE(found.extra.empty());
  const ObjectScore missed = ScoreObjects(Truth(), {}, kSame, {true, false, false});
  EXPECT_EQ(missed.missed, std::vector<std::size_t>{0});
}

TEST(ObjectScoreTest, OfTwoThingsInOnePlaceTheOneOfItsClassIsMeant) {
  MapObject chair = Truth()[0];
  chair.labels = {{kChair, 1.0f}};
  const std::vector<MapObject> truth{Truth()[0], chair};
  const std::vector<MapObject> estimate{Moved(chair, 0.1, 0.0), Moved(Truth()[0], 0.1, 0.0)};
  const ObjectScore score = ScoreObjects(truth, estimate, kSame, {true, true});
  EXPECT_EQ(score.right_class(), 2u);
}

TEST(ObjectScoreTest, TheMapsPoseIsTakenOut) {
  const Rigid3d T_world_map = Eigen::Translation3d(3.0, -2.0, 1.2) *
                              Rigid3d(Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitZ()));
  std::vector<MapObject> in_map;
  for (const MapObject& object : Truth()) in_map.push_back(InWorld(object, T_world_map.inverse()));
  const ObjectScore score = ScoreObjects(Truth(), in_map, T_world_map, kAll);
  ASSERT_EQ(score.matches.size(), 3u);
  EXPECT_NEAR(score.position_m().max, 0.0, 1e-9);
  EXPECT_NEAR(score.height_m().max, 0.0, 1e-9);
  const MapObject back = InWorld(in_map[1], T_world_map);
  EXPECT_TRUE(back.T_map_box.isApprox(Truth()[1].T_map_box, 1e-9));
  EXPECT_TRUE(back.footprint_m[0].isApprox(Truth()[1].footprint_m[0], 1e-9));
}

TEST(ObjectScoreTest, RefusesOptionsOutOfRange) {
  ObjectScoreOptions options;
  options.min_overlap = 0.0;
  EXPECT_THROW(ScoreObjects({}, {}, kSame, {}, options), ConfigError);
}

}  // namespace
}  // namespace semantic_slam
