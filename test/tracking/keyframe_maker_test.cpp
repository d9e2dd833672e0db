#include "semantic_slam/tracking/keyframe_maker.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "testing/small_room.h"

namespace semantic_slam {
namespace {

class KeyframeMakerTest : public testing::Test {
 protected:
  // An image 2 m before a wall, with nothing known of its features.
  static FrameInWork Frame() { return FrameInWork(SquaresFeatures(1)); }

  KeyframeId Insert(FrameInWork& frame) { return maker_.Insert(*SmallCamera(), frame); }

  // A frame that shows the first `count` points of a keyframe that knows all.
  FrameInWork Showing(int count) {
    FrameInWork known = Frame();
    Insert(known);
    FrameInWork frame = Frame();
    for (std::size_t i = 0; i < frame.points.size() && frame.inliers < count; ++i) {
      frame.points[i] = known.points[i];
      frame.inliers += frame.points[i] != kNoPoint;
    }
    return frame;
  }

  Map map_{SmallExtractor().scales()};
  KeyframeMaker maker_{TrackerOptions(), map_};
};

TEST_F(KeyframeMakerTest, FeaturesWithDepthBecomePointsButNotWhatMoves) {
  FrameInWork frame = Frame();
  const int features = static_cast<int>(frame.features->size());
  for (int i = 0; i < 100; ++i) frame.moves[i] = true;
  const KeyframeId id = Insert(frame);
  EXPECT_EQ(frame.reference, id);
  EXPECT_EQ(map_.point_count(), static_cast<std::size_t>(features - 100));
  EXPECT_EQ(std::count(frame.points.begin(), frame.points.begin() + 100, kNoPoint), 100);
}

TEST_F(KeyframeMakerTest, PointsThatAreKnownAreSeenAgain) {
  FrameInWork frame = Showing(50);
  const std::size_t before = map_.point_count();
  const KeyframeId id = Insert(frame);
  EXPECT_EQ(map_.FindPoint(frame.points[0])->observations.back().keyframe, id);
  EXPECT_EQ(map_.point_count(), before + frame.features->size() - 50);
}

TEST_F(KeyframeMakerTest, WantsOneWhenNearPointsRunOut) {
  EXPECT_TRUE(maker_.WantsKeyframe(Showing(80)));
  EXPECT_FALSE(maker_.WantsKeyframe(Showing(150)));
}

TEST_F(KeyframeMakerTest, WhatMovesIsNoReasonForOne) {
  FrameInWork frame = Showing(80);
  for (std::size_t i = 0; i < frame.moves.size(); ++i) frame.moves[i] = frame.points[i] == kNoPoint;
  EXPECT_FALSE(maker_.WantsKeyframe(frame));
}

TEST_F(KeyframeMakerTest, WantsOneWhenMuchIsLostOfWhatWasSeen) {
  FrameInWork frame = Showing(300);
  EXPECT_FALSE(maker_.WantsKeyframe(frame));
  frame.inliers = 181;
  EXPECT_FALSE(maker_.WantsKeyframe(frame));
  frame.inliers = 179;
  EXPECT_TRUE(maker_.WantsKeyframe(frame));
}

TEST_F(KeyframeMakerTest, WantsOneAfterManyImages) {
  const FrameInWork frame = Showing(300);
  for (int i = 0; i < 29; ++i) maker_.CountImage();
  EXPECT_FALSE(maker_.WantsKeyframe(frame));
  maker_.CountImage();
  EXPECT_TRUE(maker_.WantsKeyframe(frame));
  maker_.Reset();
  EXPECT_FALSE(maker_.WantsKeyframe(frame));
}

}  // namespace
}  // namespace semantic_slam
