#include "semantic_slam/tracking/feature_motion.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "tracking/moving_points.h"

namespace semantic_slam {
namespace {

using Verdict = FeatureMotion::Verdict;

constexpr int kImages = 8;  // 0.23 s: about the window
const Eigen::Vector3d kBody(0.2, 0.5, 0.1);

class FeatureMotionTest : public testing::Test {
 protected:
  // What the features of the last of `images` images do.
  std::vector<FeatureMotion> Follow(int images) {
    std::vector<FeatureMotion> motions;
    for (int i = 0; i < images; ++i) {
      motions =
          motions_.Follow(world_.See(i, MovingCamera(i)), MovingCameraStep(i), *SmallCamera());
    }
    return motions;
  }

  static int Count(const std::vector<FeatureMotion>& motions, Verdict verdict, int begin, int end) {
    return static_cast<int>(std::count_if(
        motions.begin() + begin, motions.begin() + end,
        [verdict](const FeatureMotion& motion) { return motion.verdict == verdict; }));
  }

  PointWorld world_;
  FeatureMotions motions_{FeatureMotionOptions(), ObservationNoise(), SmallExtractor().scales()};
};

TEST_F(FeatureMotionTest, AWorldThatStandsStillDoes) {
  world_.AddWall();
  const std::vector<FeatureMotion> motions = Follow(kImages);
  EXPECT_EQ(Count(motions, Verdict::kMoves, 0, 400), 0);
  EXPECT_GT(Count(motions, Verdict::kStill, 0, 400), 350);  // some have left the view
}

TEST_F(FeatureMotionTest, TellsHowFastSomethingMoves) {
  world_.AddWall();
  world_.Add(40, {0.0, 0.0, 2.0}, kBody, {0.8, 0.0, 0.0});
  const std::vector<FeatureMotion> motions = Follow(kImages);
  for (std::size_t i = 400; i < motions.size(); ++i) {
    ASSERT_EQ(motions[i].verdict, Verdict::kMoves) << i;
    // Over 0.23 s noise of 0.4 px, at 2 m and f = 260 px, is 0.02 m/s.
    EXPECT_LT((motions[i].velocity_mps - Eigen::Vector3d(0.8, 0.0, 0.0)).norm(), 0.1) << i;
  }
  EXPECT_EQ(Count(motions, Verdict::kMoves, 0, 400), 0);
}

TEST_F(FeatureMotionTest, SeesWhatComesNearer) {
  world_.AddWall();
  world_.Add(40, {0.0, 0.0, 1.7}, kBody, {0.0, 0.0, -1.5});
  EXPECT_GT(Count(Follow(kImages), Verdict::kMoves, 400, 440), 35);
}

TEST_F(FeatureMotionTest, ManyFeaturesInASmallPlaceDoNotOutvoteTheImage) {
  world_.AddWall(300);
  world_.Add(400, {0.0, 0.0, 2.0}, kBody, {0.8, 0.0, 0.0});
  const std::vector<FeatureMotion> motions = Follow(kImages);
  EXPECT_EQ(Count(motions, Verdict::kMoves, 0, 300), 0);
  EXPECT_GT(Count(motions, Verdict::kMoves, 300, 700), 390);
}

TEST_F(FeatureMotionTest, WhatIsLeftOutHasNoVote) {
  // Two thirds of the image move; who knows that can tell.
  world_.Add(150, {-1.6, 0.0, 4.0}, {0.7, 1.7, 0.1});
  world_.Add(300, {0.8, 0.0, 3.9}, {1.4, 1.7, 0.1}, {0.4, 0.4, 0.0});
  std::vector<bool> moves(450, false);
  std::fill(moves.begin() + 150, moves.end(), true);
  std::vector<FeatureMotion> motions;
  for (int i = 0; i < kImages; ++i) {
    motions = motions_.Follow(world_.See(i, MovingCamera(i)), MovingCameraStep(i), *SmallCamera());
    motions_.LeaveOut(moves);
  }
  EXPECT_GT(Count(motions, Verdict::kStill, 0, 150), 100);
  EXPECT_GT(Count(motions, Verdict::kMoves, 150, 450), 200);
}

TEST_F(FeatureMotionTest, SaysNothingOfTheFirstImageOrOfWhatIsSlow) {
  world_.AddWall();
  world_.Add(40, {0.0, 0.0, 2.0}, kBody, {0.1, 0.0, 0.0});
  EXPECT_EQ(Count(Follow(1), Verdict::kUnknown, 0, 440), 440);
  motions_.Reset();
  EXPECT_EQ(Count(Follow(kImages), Verdict::kMoves, 0, 440), 0);
}

TEST_F(FeatureMotionTest, SaysNothingWhereTooFewAgree) {
  // Half of the image goes to the left, half to the right.
  world_.Add(200, {-1.2, 0.0, 4.0}, {1.1, 1.7, 0.1}, {-0.8, 0.0, 0.0});
  world_.Add(200, {1.2, 0.0, 4.0}, {1.1, 1.7, 0.1}, {0.8, 0.0, 0.0});
  EXPECT_EQ(Count(Follow(kImages), Verdict::kMoves, 0, 400), 0);
}

TEST_F(FeatureMotionTest, RefusesOptionsOutOfRange) {
  FeatureMotionOptions options;
  options.window_s = 0.0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { FeatureMotions(options, ObservationNoise(), {1.0f}); }),
            "window_s = 0, but must be in [0.05, 5]");
}

}  // namespace
}  // namespace semantic_slam
