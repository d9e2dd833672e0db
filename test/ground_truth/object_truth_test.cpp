#include "semantic_slam/ground_truth/object_truth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ground_truth/small_world.h"

namespace semantic_slam {
namespace {

constexpr double kHairM = 0.0011;  // that outlines are wider, so that sheets have one

TEST(ObjectTruthTest, ATableIsItsBoxAndOpenBelow) {
  WorldObject table = MakeObject(kTable, TableMesh(), At(2.0, 1.0, 0.5));
  table.instance = 7;
  const MapObject truth = TrueObject(table, SmallVocabulary());
  EXPECT_EQ(truth.id, 7);
  ASSERT_EQ(truth.labels.size(), 1u);
  EXPECT_EQ(truth.labels[0].label, kTable);
  EXPECT_EQ(truth.labels[0].probability, 1.0f);
  EXPECT_TRUE(truth.position_m.isApprox(Eigen::Vector3d(2.0, 1.0, 0.37), 1e-5));
  EXPECT_NEAR(truth.box_size_m.x(), 1.2, 2 * kHairM);
  EXPECT_NEAR(truth.box_size_m.y(), 0.8, 2 * kHairM);
  EXPECT_NEAR(truth.box_size_m.z(), 0.74, 1e-6);
  const Eigen::Matrix3d R = truth.T_map_box.linear();
  EXPECT_NEAR(std::atan2(R(1, 0), R(0, 0)), 0.5, 1e-3);  // the hair has axes of its own
  EXPECT_NEAR(truth.min_height_m, 0.0, 1e-6);
  EXPECT_NEAR(truth.max_height_m, 0.74, 1e-6);
  EXPECT_NEAR(Area(truth.footprint_m), 1.2 * 0.8, 0.005);
  EXPECT_EQ(truth.hollow, Hollowness::kFull);
}

TEST(ObjectTruthTest, HollowIsWhatIsOpenByItsShape) {
  // A desk of a top on two pedestals that take up half of the room below it.
  Mesh desk = BoxMesh({0, 0, 0.72f}, {1.6f, 0.8f, 0.04f});
  for (const float x : {-0.6f, 0.6f}) Append(desk, BoxMesh({x, 0, 0.35f}, {0.4f, 0.8f, 0.7f}));
  EXPECT_EQ(TrueObject(MakeObject(kTable, desk), SmallVocabulary()).hollow, Hollowness::kPartly);
  const Mesh block = BoxMesh({0, 0, 0.37f}, {1.2f, 0.8f, 0.74f});
  EXPECT_EQ(TrueObject(MakeObject(kTable, block), SmallVocabulary()).hollow, Hollowness::kNo);
  // Too low for anybody to fit below.
  const Mesh low =
      Merged({BoxMesh({0, 0, 0.2f}, {1, 1, 0.04f}), BoxMesh({0, 0, 0.1f}, {0.1f, 0.1f, 0.2f})});
  EXPECT_EQ(TrueObject(MakeObject(kTable, low), SmallVocabulary()).hollow, Hollowness::kNo);
}

TEST(ObjectTruthTest, AChairsTopIsItsSeat) {
  Mesh chair = BoxMesh({0, 0, 0.45f}, {0.45f, 0.45f, 0.04f});
  Append(chair, BoxMesh({-0.2f, 0, 0.7f}, {0.04f, 0.45f, 0.5f}));  // back
  for (const float x : {-0.2f, 0.2f}) {
    for (const float y : {-0.2f, 0.2f})
      Append(chair, BoxMesh({x, y, 0.22f}, {0.04f, 0.04f, 0.44f}));
  }
  const LabelVocabulary vocabulary({{0, "unknown"}, {kChair, "chair", {1, 2, 3}, true, true}});
  EXPECT_EQ(TrueObject(MakeObject(kChair, chair), vocabulary).hollow, Hollowness::kFull);
}

TEST(ObjectTruthTest, ASheetOnAWallHasAThinFootprint) {
  const MapObject truth = TrueObject(
      MakeObject(kLamp, QuadMesh({0, 0, 1.5f}, {0.6f, 0, 0}, {0, 0, -0.4f})), SmallVocabulary());
  EXPECT_FALSE(truth.footprint_m.empty());
  EXPECT_NEAR(truth.box_size_m.x(), 0.6, 2 * kHairM);
  EXPECT_NEAR(truth.box_size_m.y(), 0.0, 2 * kHairM);
  EXPECT_NEAR(truth.min_height_m, 1.1, 1e-6);
  EXPECT_EQ(truth.hollow, Hollowness::kNo);
}

TEST(ObjectTruthTest, ListsWhatStandsStillAndIsNoPartOfTheBuilding) {
  World world = SmallWorld();
  WorldObject walker = MakeObject(kChair, BoxMesh({0, 0, 1}, {0.4f, 0.4f, 1.8f}));
  walker.walk.emplace(std::vector<Eigen::Vector2d>{{1, 1}, {3, 1}}, 1.0);
  world.objects.push_back(walker);
  world.objects.push_back(MakeObject(kChair, {}));
  const ObjectMap map = TrueObjects(world, SmallVocabulary());
  EXPECT_EQ(map.vocabulary_hash, SmallVocabulary().hash());
  ASSERT_EQ(map.objects.size(), 2u);
  EXPECT_EQ(map.objects[0].id, 3);  // floor and walls are 1 and 2
  EXPECT_EQ(map.objects[1].id, 4);
}

}  // namespace
}  // namespace semantic_slam
