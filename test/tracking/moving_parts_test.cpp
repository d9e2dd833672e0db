#include "semantic_slam/tracking/moving_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "testing/expect_error.h"
#include "tracking/moving_points.h"

namespace semantic_slam {
namespace {

constexpr int kImages = 9;
const Eigen::Vector3d kBody(0.2, 0.5, 0.1);
const Eigen::Vector3d kWalk(0.8, 0.0, 0.0);

class MovingPartsTest : public testing::Test {
 protected:
  // What moves in the last of the images from `begin` to `end`.
  std::vector<bool> Find(int begin, int end) {
    std::vector<bool> moves;
    for (int i = begin; i < end; ++i) {
      const auto features = world_.See(i, MovingCamera(i));
      moves = parts_.Find(features, MovingCameraStep(i), std::vector<bool>(features->size(), false),
                          *SmallCamera());
    }
    return moves;
  }

  static int Count(const std::vector<bool>& moves, int begin, int end) {
    return static_cast<int>(std::count(moves.begin() + begin, moves.begin() + end, true));
  }

  static MovingParts Parts(const MovingPartsOptions& options = {}) {
    return MovingParts(options, FeatureMotionOptions(), ObservationNoise(),
                       SmallExtractor().scales());
  }

  PointWorld world_;
  MovingParts parts_ = Parts();
};

TEST_F(MovingPartsTest, FindsWhoWalksAndNothingElse) {
  world_.AddWall();
  world_.Add(60, {0.0, 0.0, 2.0}, kBody, kWalk);
  const std::vector<bool> moves = Find(0, kImages);
  EXPECT_EQ(Count(moves, 0, 400), 0);
  EXPECT_EQ(Count(moves, 400, 460), 60);
}

TEST_F(MovingPartsTest, LeavesAStillWorldAlone) {
  world_.AddWall();
  for (int end = 1; end <= 15; ++end) EXPECT_EQ(Count(Find(end - 1, end), 0, 400), 0) << end;
}

TEST_F(MovingPartsTest, OneImageIsNotEnough) {
  world_.AddWall();
  world_.Add(60, {0.0, 0.0, 2.0}, kBody, {2.5, 0.0, 0.0});
  EXPECT_EQ(Count(Find(0, 3), 400, 460), 0) << "seen to move in two images";
  EXPECT_EQ(Count(Find(3, 5), 400, 460), 60);
}

TEST_F(MovingPartsTest, AFewFeaturesAreNoPart) {
  world_.AddWall();
  world_.Add(9, {0.0, 0.0, 2.0}, kBody, kWalk);
  EXPECT_EQ(Count(Find(0, kImages), 0, 409), 0);
}

TEST_F(MovingPartsTest, WhatMovesEachItsOwnWayIsNoPart) {
  world_.AddWall();
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * M_PI * i / 24.0 * 11.0;  // neighbours differ by 165 degrees
    world_.Add(1, {-0.6 + 0.05 * i, 0.0, 2.0}, Eigen::Vector3d::Zero(),
               {0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.0});
  }
  EXPECT_EQ(Count(Find(0, kImages), 400, 424), 0);
}

TEST_F(MovingPartsTest, WhatIsScatteredAmongThingsThatStandStillIsNoPart) {
  world_.AddWall(1200);
  world_.Add(60, {0.0, 0.0, 4.0}, {2.0, 1.5, 0.1}, kWalk);  // wrong depths at edges look like this
  EXPECT_EQ(Count(Find(0, kImages), 1200, 1260), 0);
}

TEST_F(MovingPartsTest, WhereMostOfTheImageMovesNothingIsLeftOut) {
  world_.Add(150, {-1.6, 0.0, 4.0}, {0.7, 1.7, 0.1});
  world_.Add(400, {0.8, 0.0, 3.9}, {1.4, 1.7, 0.1}, {0.3, 0.3, 0.0});
  EXPECT_EQ(Count(Find(0, kImages), 0, 550), 0);
}

TEST_F(MovingPartsTest, SwitchedOffItTellsWhatWasKnown) {
  MovingPartsOptions options;
  options.enabled = false;
  world_.AddWall(3);
  MovingParts parts = Parts(options);
  const std::vector<bool> known{false, true, false};
  EXPECT_EQ(
      parts.Find(world_.See(0, Rigid3d::Identity()), Rigid3d::Identity(), known, *SmallCamera()),
      known);
}

TEST_F(MovingPartsTest, RefusesOptionsOutOfRange) {
  MovingPartsOptions options;
  options.min_features = 1;
  EXPECT_EQ(MessageOf<ConfigError>([&] { Parts(options); }),
            "min_features = 1, but must be in [2, 1000]");
}

TEST(MarkWithoutDepthTest, AFeatureWithoutDepthIsWhatIsAroundIt) {
  std::vector<Feature> features;
  for (const float u : {40.0f, 42.0f, 44.0f, 150.0f, 152.0f, 154.0f, 280.0f}) {
    Feature feature{};
    feature.pixel = feature.raw = feature.exposed = {u, 60.0f};
    feature.depth_m = 2.0f;
    features.push_back(feature);
  }
  for (const int i : {2, 5, 6}) features[i].depth_m = std::numeric_limits<float>::quiet_NaN();
  const FrameFeatures image(Stamp{1}, features, std::vector<Descriptor>(features.size()),
                            *SmallCamera());
  std::vector<bool> marked{true, true, false, false, false, false, false};
  MarkWithoutDepth(image, *SmallCamera(), marked);
  EXPECT_EQ(marked, (std::vector<bool>{true, true, true, false, false, false, false}));
}

}  // namespace
}  // namespace semantic_slam
