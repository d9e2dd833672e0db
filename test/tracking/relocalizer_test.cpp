#include "semantic_slam/tracking/relocalizer.h"

#include <gtest/gtest.h>

#include "testing/handheld_path.h"
#include "testing/small_room.h"

namespace semantic_slam {
namespace {

constexpr int kMinInliers = 30;
constexpr Stamp kNow{1'000'000'000};

// A map of one keyframe, whose frame is the world's.
class RelocalizerTest : public testing::Test {
 protected:
  RelocalizerTest() {
    keyframe_ =
        AddKeyframeWithPoints(map_, SmallRoomFeatures(T_world_keyframe_, kNow), T_world_keyframe_);
  }

  std::optional<Relocalization> Find(const FrameFeatures& frame, int min_inliers = kMinInliers) {
    return Relocalize(frame, ViewOf(*map_.FindKeyframe(keyframe_), map_), map_.scales(),
                      *SmallCamera(), noise_, min_inliers);
  }

  const Rigid3d T_world_keyframe_ = HandheldPath::T_world_camera(0.0);
  const ObservationNoise noise_;
  Map map_{SmallExtractor().scales()};
  KeyframeId keyframe_ = kNoKeyframe;
};

TEST_F(RelocalizerTest, FindsAViewFromNearby) {
  const Rigid3d T_world_camera = Nudged(T_world_keyframe_, 0.15, 0.15, 1);
  const auto frame = SmallRoomFeatures(T_world_camera, kNow);
  const auto found = Find(*frame);
  ASSERT_TRUE(found);
  // A pixel of this camera is 8 mm at 2 m; a hundred matches do better than one.
  EXPECT_LT(DistanceBetween(found->T_map_camera, T_world_camera), 0.02);
  EXPECT_LT(AngleBetween(found->T_map_camera, T_world_camera), 0.01);
  ASSERT_EQ(found->points.size(), frame->size());
  int inliers = 0;
  for (std::size_t i = 0; i < frame->size(); ++i) {
    const MapPoint* point = map_.FindPoint(found->points[i]);
    if (point == nullptr) continue;
    ++inliers;
    const Eigen::Vector2d pixel =
        SmallCamera()->Project(found->T_map_camera.inverse() * point->position);
    // 2.45 sigma on the coarsest level (1.2^7 = 3.6 px), should the noise be as bad as it may.
    EXPECT_LT((pixel - (*frame)[i].pixel.cast<double>()).norm(), 25.0);
  }
  EXPECT_EQ(inliers, found->inliers);
  EXPECT_GE(inliers, kMinInliers);
}

TEST_F(RelocalizerTest, FindsAViewThatIsUpsideDown) {
  const Rigid3d T_world_camera =
      T_world_keyframe_ * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  const auto found = Find(*SmallRoomFeatures(T_world_camera, kNow));
  ASSERT_TRUE(found);
  EXPECT_LT(DistanceBetween(found->T_map_camera, T_world_camera), 0.02);
  EXPECT_LT(AngleBetween(found->T_map_camera, T_world_camera), 0.01);
}

TEST_F(RelocalizerTest, DoesNotKnowAnotherPlace) {
  const Rigid3d T_world_camera =
      T_world_keyframe_ * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitY());  // looking back
  EXPECT_FALSE(Find(*SmallRoomFeatures(T_world_camera, kNow)));
  EXPECT_FALSE(Find(*SquaresFeatures(1)));
}

TEST_F(RelocalizerTest, AnImageWithoutFeaturesIsNowhere) {
  EXPECT_FALSE(Find(FrameFeatures(BlankImage(kNow), *SmallCamera(), SmallExtractor())));
}

TEST_F(RelocalizerTest, TheViewOfAKeyframeHasThePointsItStillSees) {
  const Keyframe& keyframe = *map_.FindKeyframe(keyframe_);
  map_.ErasePoint(keyframe.points.front());
  const KnownView view = ViewOf(keyframe, map_);
  EXPECT_EQ(view.features, keyframe.features.get());
  EXPECT_EQ(view.points.size(), map_.point_count());
  for (const KnownView::Point& point : view.points) {
    EXPECT_EQ(point.id, keyframe.points[point.feature]);
    EXPECT_EQ(point.position, map_.FindPoint(point.id)->position);
  }
}

TEST_F(RelocalizerTest, FindsAViewByPointsThatAreNotInTheMap) {
  KnownView view = ViewOf(*map_.FindKeyframe(keyframe_), map_);
  for (KnownView::Point& point : view.points) point.id = kNoPoint;
  const Rigid3d T_world_camera = Nudged(T_world_keyframe_, 0.15, 0.15, 1);
  const auto found = Relocalize(*SmallRoomFeatures(T_world_camera, kNow), view, map_.scales(),
                                *SmallCamera(), noise_, kMinInliers);
  ASSERT_TRUE(found);
  EXPECT_LT(DistanceBetween(found->T_map_camera, T_world_camera), 0.02);
  for (const PointId id : found->points) EXPECT_EQ(id, kNoPoint);
}

TEST_F(RelocalizerTest, HasToBeSureEnough) {
  const auto frame = SmallRoomFeatures(T_world_keyframe_, kNow);
  const auto found = Find(*frame);
  ASSERT_TRUE(found);
  EXPECT_TRUE(Find(*frame, found->inliers));
  EXPECT_FALSE(Find(*frame, found->inliers + 1));
}

TEST_F(RelocalizerTest, TheSameImageGivesTheSameBytes) {
  const auto frame = SmallRoomFeatures(Nudged(T_world_keyframe_, 0.15, 0.15, 1), kNow);
  const auto first = Find(*frame), again = Find(*frame);
  ASSERT_TRUE(first && again);
  EXPECT_EQ(first->T_map_camera.matrix(), again->T_map_camera.matrix());
  EXPECT_EQ(first->points, again->points);
}

}  // namespace
}  // namespace semantic_slam
