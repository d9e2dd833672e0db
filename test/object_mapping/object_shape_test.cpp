#include "semantic_slam/object_mapping/object_shape.h"

#include <cmath>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// An upright box as an observation, straight in its keyframe's axes.
ObjectObservation Seen(const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  ObjectObservation seen;
  seen.keyframe_id = 0;
  seen.centre = centre;
  seen.covariance_m2 = 0.01 * Eigen::Matrix3d::Identity();
  const double x = 0.5 * size.x(), y = 0.5 * size.y(), z = 0.5 * size.z();
  for (const Eigen::Vector2d& corner : {Eigen::Vector2d(-x, -y), Eigen::Vector2d(x, -y),
                                        Eigen::Vector2d(x, y), Eigen::Vector2d(-x, y)}) {
    seen.body.push_back(centre + Eigen::Vector3d(corner.x(), corner.y(), 0.0));
  }
  seen.outline = seen.body;
  seen.lowest = centre - Eigen::Vector3d(0, 0, z);
  seen.highest = centre + Eigen::Vector3d(0, 0, z);
  seen.quality = 1.0;
  return seen;
}

Rigid3d AtOrigin(KeyframeId) {
  return Rigid3d::Identity();
}

const Eigen::Vector3d kCentre(1.0, 2.0, 0.4), kSize(1.2, 0.6, 0.8);

ObjectShape Shape(const std::vector<ObjectObservation>& seen) {
  const auto shape = FuseObservations(seen, AtOrigin);
  EXPECT_TRUE(shape);
  return shape.value_or(ObjectShape());
}

TEST(FuseObservationsTest, OneObservationIsTheShape) {
  const ObjectShape shape = Shape({Seen(kCentre, kSize)});
  EXPECT_NEAR((shape.position_m - kCentre).norm(), 0.0, 1e-12);
  EXPECT_NEAR(Area(shape.body_m), 0.72, 1e-9);
  EXPECT_NEAR(shape.box.size.x(), 1.2, 1e-9);
  EXPECT_NEAR(shape.min_height_m, 0.0, 1e-9);
  EXPECT_NEAR(shape.max_height_m, 0.8, 1e-9);
}

TEST(FuseObservationsTest, ItMovesWithItsKeyframe) {
  const Rigid3d T_map_keyframe = Eigen::Translation3d(5.0, -1.0, 0.2) *
                                 Rigid3d(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  const auto shape =
      FuseObservations({Seen(kCentre, kSize)}, [&](KeyframeId) { return T_map_keyframe; });
  ASSERT_TRUE(shape);
  EXPECT_NEAR((shape->position_m - T_map_keyframe * kCentre).norm(), 0.0, 1e-12);
  EXPECT_NEAR(shape->box.yaw_rad, 0.5, 1e-9);
  EXPECT_NEAR(shape->min_height_m, 0.2, 1e-9);
}

TEST(FuseObservationsTest, PartsInViewDoNotShiftWhatWasOnceSeenWhole) {
  std::vector<ObjectObservation> seen{Seen(kCentre, kSize)};
  for (int i = 0; i < 10; ++i) {
    seen.push_back(Seen(kCentre + Eigen::Vector3d(0.4, 0, 0), {0.4, 0.6, 0.8}));
    seen.back().complete = false;
  }
  const ObjectShape shape = Shape(seen);
  EXPECT_NEAR((shape.position_m - kCentre).norm(), 0.0, 1e-12);
  EXPECT_NEAR(Area(shape.body_m), 0.72, 1e-9);
}

TEST(FuseObservationsTest, PartsAloneMakeAWhole) {
  std::vector<ObjectObservation> seen;
  for (int i = 0; i < 4; ++i) {
    const double side = i % 2 == 0 ? 0.3 : -0.3;
    seen.push_back(Seen(kCentre + Eigen::Vector3d(side, 0, 0), {0.6, 0.6, 0.8}));
    seen.back().complete = false;
  }
  EXPECT_NEAR(Area(Shape(seen).body_m), 0.72, 1e-9);
}

TEST(FuseObservationsTest, AFewWrongOnesDoNoHarm) {
  std::vector<ObjectObservation> seen(8, Seen(kCentre, kSize));
  seen.push_back(Seen(kCentre + Eigen::Vector3d(1.0, 0.5, 0.3), {2.0, 2.0, 2.0}));
  const ObjectShape shape = Shape(seen);
  EXPECT_NEAR(Area(shape.body_m), 0.72, 1e-9);
  EXPECT_NEAR((shape.position_m - kCentre).norm(), 0.0, 1e-9);
  EXPECT_NEAR(shape.max_height_m, 0.8, 1e-9);
}

TEST(FuseObservationsTest, ManyPoorOnesWeighLessThanAFewGoodOnes) {
  std::vector<ObjectObservation> seen(3, Seen(kCentre, kSize));
  for (ObjectObservation& one : seen) one.quality = 10.0;
  for (int i = 0; i < 6; ++i) seen.push_back(Seen(kCentre, {2.0, 2.0, 2.0}));
  EXPECT_NEAR(Area(Shape(seen).body_m), 0.72, 1e-9);
}

TEST(FuseObservationsTest, MoreObservationsAreSurerButNeverCertain) {
  const double once = Shape({Seen(kCentre, kSize)}).covariance_m2(0, 0);
  const double often =
      Shape(std::vector<ObjectObservation>(20, Seen(kCentre, kSize))).covariance_m2(0, 0);
  EXPECT_LT(often, 0.1 * once);
  EXPECT_GE(often, 0.01 * 0.01);
}

TEST(FuseObservationsTest, NothingMakesNoShape) {
  EXPECT_FALSE(FuseObservations({}, AtOrigin));
  ObjectObservation line = Seen(kCentre, kSize);
  line.body.resize(2), line.outline.resize(2);
  EXPECT_FALSE(FuseObservations({line}, AtOrigin));
}

TEST(OverlapTest, KnownBoxes) {
  const ObjectShape a = Shape({Seen(kCentre, kSize)});
  EXPECT_NEAR(OverlapOf(a, a).of_union, 1.0, 1e-9);
  EXPECT_NEAR(OverlapOf(a, a).of_smaller, 1.0, 1e-9);
  // 5 cm of margin all around: 1.3 x 0.7 x 0.9, shifted by half of the length.
  const ObjectShape shifted = Shape({Seen(kCentre + Eigen::Vector3d(0.65, 0, 0), kSize)});
  EXPECT_NEAR(OverlapOf(a, shifted).of_smaller, 0.5, 1e-9);
  EXPECT_NEAR(OverlapOf(a, shifted).of_union, 1.0 / 3.0, 1e-9);
  const ObjectShape above = Shape({Seen(kCentre + Eigen::Vector3d(0, 0, 1.0), kSize)});
  EXPECT_EQ(OverlapOf(a, above).of_union, 0.0);
  const ObjectShape far = Shape({Seen(kCentre + Eigen::Vector3d(9, 0, 0), kSize)});
  EXPECT_EQ(OverlapOf(a, far).of_smaller, 0.0);
}

TEST(OverlapTest, APartIsAllOfItselfButLittleOfTheWhole) {
  const ObjectShape table = Shape({Seen({0, 0, 0.4}, {2.0, 1.0, 0.8})});
  const ObjectShape part = Shape({Seen({0.5, 0, 0.4}, {0.4, 0.6, 0.6})});
  EXPECT_GT(OverlapOf(table, part).of_smaller, 0.95);
  EXPECT_LT(OverlapOf(table, part).of_union, 0.2);
}

TEST(OverlapTest, ThinThingsOverlapDespiteErrorsOfDepth) {
  const ObjectShape screen = Shape({Seen({0, 0, 1}, {0.6, 0.02, 0.4})});
  const ObjectShape again = Shape({Seen({0, 0.05, 1}, {0.6, 0.02, 0.4})});
  EXPECT_GT(OverlapOf(screen, again).of_smaller, 0.5);
}

}  // namespace
}  // namespace semantic_slam
