#include "semantic_slam/tracking/lost_camera.h"

#include <set>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

class LostCameraTest : public testing::Test {
 protected:
  static TrackerOptions Options() {
    TrackerOptions options;
    options.relocalization_keyframes = 2;
    return options;
  }

  static std::shared_ptr<const FrameFeatures> Blank(Stamp stamp) {
    return std::make_shared<const FrameFeatures>(BlankImage(stamp), *SmallCamera(),
                                                 SmallExtractor());
  }

  const PlaceIndex index_{PlaceIndexOptions()};  // knows nothing
  LostCamera lost_{Options(), index_};
};

TEST_F(LostCameraTest, WaitsInSightOfEnoughBeforeAMapBegins) {
  const auto seen = SquaresFeatures(1);  // at 1 s
  const auto later = [&](double seconds) {
    const Stamp stamp{seen->stamp().ns + static_cast<std::int64_t>(1e9 * seconds)};
    return FrameFeatures(stamp, seen->features(), seen->descriptors(), *SmallCamera());
  };
  EXPECT_TRUE(lost_.CanBeginMap(*seen));
  EXPECT_FALSE(lost_.IsLostForLong(*seen));
  EXPECT_FALSE(lost_.IsLostForLong(later(0.9)));
  EXPECT_TRUE(lost_.IsLostForLong(later(1.0)));
  EXPECT_FALSE(lost_.IsLostForLong(*Blank(later(1.1).stamp()))) << "a covered lens";
  EXPECT_FALSE(lost_.IsLostForLong(later(1.2)));
  EXPECT_TRUE(lost_.IsLostForLong(later(2.2)));
  lost_.ForgetUnknown();
  EXPECT_FALSE(lost_.IsLostForLong(later(2.3)));
}

TEST_F(LostCameraTest, IsCarefulForAWhileAfterItWasFound) {
  const TrackerOptions options;
  lost_.BeginMap();
  EXPECT_EQ(lost_.MinInliers(), options.min_inliers);
  EXPECT_FALSE(lost_.IsJustFound());
  lost_.Found();
  EXPECT_TRUE(lost_.IsJustFound());
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(lost_.MinInliers(), options.min_relocalization_inliers) << i;
    lost_.CountImage();
  }
  EXPECT_EQ(lost_.MinInliers(), options.min_inliers);
}

TEST_F(LostCameraTest, WithoutAnIdeaAllKeyframesTakeTurns) {
  Map map(SmallExtractor().scales());
  std::set<KeyframeId> all;
  for (int i = 0; i < 3; ++i) {
    all.insert(AddKeyframeWithPoints(map, SquaresFeatures(i), Rigid3d::Identity()));
  }
  const std::vector<KeyframeId> first = lost_.Candidates(*SquaresFeatures(9), map);
  const std::vector<KeyframeId> second = lost_.Candidates(*SquaresFeatures(9), map);
  EXPECT_EQ(first.size(), 2u);
  std::set<KeyframeId> tried(first.begin(), first.end());
  tried.insert(second.begin(), second.end());
  EXPECT_EQ(tried, all);
}

}  // namespace
}  // namespace semantic_slam
