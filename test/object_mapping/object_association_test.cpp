#include "semantic_slam/object_mapping/object_association.h"

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

constexpr LabelId kTv = 1, kLaptop = 2;
constexpr int kClasses = 64;

ObjectObservation Seen(double x, const Eigen::Vector3d& size) {
  ObjectObservation seen;
  seen.keyframe_id = 0;
  seen.centre = {x, 0.0, 0.5};
  seen.covariance_m2 = 0.01 * Eigen::Matrix3d::Identity();
  const double dx = 0.5 * size.x(), dy = 0.5 * size.y();
  seen.body = {{x - dx, -dy, 0.5}, {x + dx, -dy, 0.5}, {x + dx, dy, 0.5}, {x - dx, dy, 0.5}};
  seen.outline = seen.body;
  seen.lowest = {x, 0.0, 0.5 - 0.5 * size.z()};
  seen.highest = {x, 0.0, 0.5 + 0.5 * size.z()};
  seen.quality = 1.0;
  return seen;
}

Rigid3d AtOrigin(KeyframeId) {
  return Rigid3d::Identity();
}

Sighting Shown(TrackId track, LabelId label, double x,
               const Eigen::Vector3d& size = {0.5, 0.5, 0.5}) {
  const ObjectObservation seen = Seen(x, size);
  return {cv::Rect2f(static_cast<float>(100 * x), 0, 50, 50),
          {{track, label, 0.8f}},
          seen,
          *FuseObservations({seen}, AtOrigin)};
}

MappedObject Known(ObjectId id, LabelId label, double x,
                   const Eigen::Vector3d& size = {0.5, 0.5, 0.5}) {
  MappedObject object(id, kClasses);
  object.Add(Seen(x, size), {}, Stamp{1});
  object.AddLabel(label, 0.8f);
  object.Place(AtOrigin);
  return object;
}

TEST(AssociateSightingsTest, SameClassAndPlaceIsTheSameObject) {
  const std::vector<MappedObject> known{Known(1, kTv, 0.0), Known(2, kTv, 1.0)};
  const auto shown = AssociateSightings(
      {Shown(7, kTv, 1.1), Shown(8, kTv, 0.1), Shown(9, kTv, 2.0)}, known, {}, {});
  EXPECT_EQ(shown[0], 1u);
  EXPECT_EQ(shown[1], 0u);
  EXPECT_EQ(shown[2], std::nullopt);
}

TEST(AssociateSightingsTest, AnotherClassNeedsNearlyTheSamePlace) {
  const std::vector<MappedObject> known{Known(1, kTv, 0.0)};
  EXPECT_EQ(AssociateSightings({Shown(7, kLaptop, 0.05)}, known, {}, {})[0], 0u);
  EXPECT_EQ(AssociateSightings({Shown(7, kLaptop, 0.3)}, known, {}, {})[0], std::nullopt);
  EXPECT_EQ(AssociateSightings({Shown(7, kTv, 0.3)}, known, {}, {})[0], 0u);
}

TEST(AssociateSightingsTest, ASmallThingOnALargeOneIsItsOwn) {
  const std::vector<MappedObject> known{Known(1, kTv, 0.0, {2.0, 1.0, 0.8})};
  EXPECT_EQ(AssociateSightings({Shown(7, kLaptop, 0.2, {0.3, 0.3, 0.3})}, known, {}, {})[0],
            std::nullopt);
}

TEST(AssociateSightingsTest, ATrackStaysWithItsObjectWhileItIsNear) {
  const std::vector<MappedObject> known{Known(1, kTv, 0.0)};
  const TrackLinks links{{7, 1}};
  EXPECT_EQ(AssociateSightings({Shown(7, kTv, 0.65)}, known, links, {})[0],
            0u);  // no overlap, but near
  EXPECT_EQ(AssociateSightings({Shown(8, kTv, 0.65)}, known, links, {})[0], std::nullopt);
  EXPECT_EQ(AssociateSightings({Shown(7, kTv, 3.0)}, known, links, {})[0], std::nullopt);
}

TEST(AssociateSightingsTest, ATrackThatHasJumpedToAnotherObjectShowsThatOne) {
  const std::vector<MappedObject> known{Known(1, kTv, 0.0), Known(2, kTv, 0.7)};
  EXPECT_EQ(AssociateSightings({Shown(7, kTv, 0.7)}, known, {{7, 1}}, {})[0], 1u);
}

TEST(AssociateSightingsTest, TwoSightingsNeverShowOneObject) {
  const std::vector<MappedObject> known{Known(1, kTv, 0.0)};
  const auto shown = AssociateSightings({Shown(7, kTv, 0.1), Shown(8, kTv, 0.02)}, known, {}, {});
  EXPECT_EQ(shown[0], std::nullopt);
  EXPECT_EQ(shown[1], 0u);
}

TEST(AssociateSightingsTest, NothingWithNothing) {
  EXPECT_TRUE(AssociateSightings({}, {Known(1, kTv, 0.0)}, {}, {}).empty());
  EXPECT_EQ(AssociateSightings({Shown(7, kTv, 0.0)}, {}, {}, {}),
            std::vector<std::optional<std::size_t>>{std::nullopt});
}

TEST(JoinDoublesTest, TwoNamesForOneBoxAreOneSighting) {
  std::vector<Sighting> sightings{Shown(1, kLaptop, 0.0), Shown(2, kTv, 0.02), Shown(3, kTv, 2.0)};
  sightings[1].names[0].confidence = 0.9f;
  JoinDoubles(sightings, {});
  ASSERT_EQ(sightings.size(), 2u);
  EXPECT_EQ(sightings[0].names.size(), 2u);
  EXPECT_EQ(sightings[0].names[0].track, 2);  // the surer one first
  EXPECT_EQ(sightings[1].names[0].track, 3);
}

TEST(AreOneTest, ByClassAndOverlap) {
  EXPECT_TRUE(AreOne(Known(1, kTv, 0.0), Known(2, kTv, 0.2), {}));
  EXPECT_FALSE(AreOne(Known(1, kTv, 0.0), Known(2, kTv, 0.5), {}));
  EXPECT_FALSE(AreOne(Known(1, kTv, 0.0), Known(2, kLaptop, 0.3), {}));
  EXPECT_TRUE(AreOne(Known(1, kTv, 0.0), Known(2, kLaptop, 0.1), {}));
  EXPECT_TRUE(AreOne(Known(1, kTv, 0.0, {2, 1, 0.8}), Known(2, kTv, 0.5, {0.4, 0.4, 0.4}), {}));
}

}  // namespace
}  // namespace semantic_slam
