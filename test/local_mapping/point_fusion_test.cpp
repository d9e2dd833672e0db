#include "semantic_slam/local_mapping/point_fusion.h"

#include <gtest/gtest.h>

#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

// Two views of the room, a few centimetres apart, each with points of its own.
class PointFusionTest : public testing::Test {
 protected:
  PointFusionTest() : map_(SmallExtractor().scales()) {
    for (int i = 0; i < 2; ++i) {
      const Rigid3d T = HandheldPath::T_world_camera(3.0 + 0.1 * i);
      AddKeyframeWithPoints(map_, SmallRoomFeatures(T, Stamp{1'000'000'000 * (i + 1)}), T);
    }
  }

  void Fuse(const std::vector<PointId>& points) {
    FusePoints(points, 1, 3.0f, *SmallCamera(), ObservationNoise(), map_);
  }

  int Shared() const {
    int shared = 0;
    for (const PointId id : map_.FindKeyframe(1)->points) {
      const MapPoint* point = map_.FindPoint(id);
      shared += point != nullptr && point->observations.size() == 2;
    }
    return shared;
  }

  Map map_;
};

TEST_F(PointFusionTest, PointsOfTwoViewsBecomeOne) {
  const std::size_t before = map_.point_count();
  EXPECT_EQ(Shared(), 0);
  Fuse(PointsOf(*map_.FindKeyframe(0)));
  EXPECT_GT(Shared(), 100);  // of about 450 features
  EXPECT_EQ(map_.point_count(), before - Shared());
}

TEST_F(PointFusionTest, APointIsNotTakenForWhatLiesBehindIt) {
  const std::vector<PointId> points = PointsOf(*map_.FindKeyframe(0));
  const Eigen::Vector3d eye = map_.KeyframePose(1).translation();
  for (const PointId id : points) {
    Eigen::Vector3d& p = map_.FindPoint(id)->position;
    p = eye + 1.4 * (p - eye);  // on the same ray, where no depth sensor would have it
  }
  Fuse(points);
  EXPECT_EQ(Shared(), 0);
}

TEST_F(PointFusionTest, PointsThatAreGoneAreLeftOut) {
  const std::vector<PointId> points = PointsOf(*map_.FindKeyframe(0));
  for (const PointId id : points) map_.ErasePoint(id);
  Fuse(points);
  EXPECT_EQ(Shared(), 0);
  EXPECT_TRUE(PointsOf(*map_.FindKeyframe(0)).empty());
}

}  // namespace
}  // namespace semantic_slam
