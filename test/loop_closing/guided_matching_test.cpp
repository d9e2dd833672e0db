#include "semantic_slam/loop_closing/guided_matching.h"

#include <gtest/gtest.h>

#include "loop_closing/two_visits.h"

namespace semantic_slam {
namespace {

std::vector<MapPoint> FirstVisitsPoints(const Map& map) {
  std::vector<MapPoint> points;
  map.ForEachPoint([&](const MapPoint& point) {
    if (point.observations.front().keyframe < TwoVisits::kVisit) points.push_back(point);
  });
  return points;
}

Relocalization MatchLast(const TwoVisits& visits, const Rigid3d& T_start) {
  return MatchAround(FirstVisitsPoints(visits.map),
                     *visits.map.FindKeyframe(TwoVisits::kLast)->features, T_start,
                     visits.map.scales(), *SmallCamera(), ObservationNoise());
}

TEST(GuidedMatchingTest, RefinesAPoseThatIsAboutKnown) {
  const TwoVisits visits;
  const Rigid3d truth = TwoVisits::TruePose(TwoVisits::kAll - 1);
  const Relocalization found = MatchLast(visits, Nudged(truth, 0.02, 0.01, 4));
  EXPECT_GT(found.inliers, 100);
  // As good as tracking without noise: a pixel of this camera is 8 mm at 2 m.
  EXPECT_LT(DistanceBetween(found.T_map_camera, truth), 0.01);
}

TEST(GuidedMatchingTest, ListsExactlyItsInliers) {
  const TwoVisits visits;
  const Relocalization found = MatchLast(visits, TwoVisits::TruePose(TwoVisits::kAll - 1));
  int points = 0;
  for (const PointId id : found.points) points += id != kNoPoint;
  EXPECT_EQ(points, found.inliers);
}

TEST(GuidedMatchingTest, WithoutPointsThereIsNothing) {
  const TwoVisits visits;
  const Rigid3d start = Rigid3d::Identity();
  const Relocalization found =
      MatchAround({}, *visits.map.FindKeyframe(0)->features, start, visits.map.scales(),
                  *SmallCamera(), ObservationNoise());
  EXPECT_EQ(found.inliers, 0);
  EXPECT_EQ(found.points.size(), visits.map.FindKeyframe(0)->features->size());
}

}  // namespace
}  // namespace semantic_slam
