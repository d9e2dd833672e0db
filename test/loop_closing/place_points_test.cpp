#include "semantic_slam/loop_closing/place_points.h"

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// Keyframes in a row; each shares `i` points with the first, i being its number.
class PlacePointsTest : public testing::Test {
 protected:
  static constexpr int kKeyframes = 13;

  PlacePointsTest() {
    for (int i = 0; i < kKeyframes; ++i) map_.AddKeyframe(features_, Rigid3d::Identity());
    for (int i = 1; i < kKeyframes; ++i) {
      for (int k = 0; k < i; ++k) {
        const PointId id = map_.AddPoint({0.0, 0.0, 2.0}, 0, feature_++).id;
        map_.AddObservation(id, i, k);
      }
      own_.push_back(map_.AddPoint({0.0, 0.0, 2.0}, i, 50).id);
    }
    map_.UpdateCovisibility(0);
  }

  const std::shared_ptr<const FrameFeatures> features_ = SquaresFeatures(1);
  Map map_{SmallExtractor().scales()};
  int feature_ = 0;
  std::vector<PointId> own_;  // by keyframe, from the second on: what nobody else sees
};

TEST_F(PlacePointsTest, AreThoseOfThePlaceAndOfTheTenThatShareMost) {
  ASSERT_LT(feature_, static_cast<int>(features_->size()));
  const std::vector<MapPoint> points = PointsAround(0, map_);
  // All that the first sees, and what the last ten of the twelve others have of their own.
  ASSERT_EQ(points.size(), static_cast<std::size_t>(feature_ + 10));
  const auto has = [&points](PointId id) {
    for (const MapPoint& point : points) {
      if (point.id == id) return true;
    }
    return false;
  };
  EXPECT_FALSE(has(own_[0]));
  EXPECT_FALSE(has(own_[1]));
  EXPECT_TRUE(has(own_[2]));
  EXPECT_TRUE(has(own_.back()));
}

TEST_F(PlacePointsTest, ComeByAscendingIdEachOnce) {
  const std::vector<MapPoint> points = PointsAround(0, map_);
  for (std::size_t i = 1; i < points.size(); ++i) EXPECT_LT(points[i - 1].id, points[i].id);
}

}  // namespace
}  // namespace semantic_slam
