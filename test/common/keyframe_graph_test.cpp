#include "semantic_slam/common/keyframe_graph.h"

#include <string>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

TEST(KeyframeGraphTest, AStatusHasAName) {
  EXPECT_EQ(std::string(ToString(TrackingStatus::kInitializing)), "initializing");
  EXPECT_EQ(std::string(ToString(TrackingStatus::kTracking)), "tracking");
  EXPECT_EQ(std::string(ToString(TrackingStatus::kLost)), "lost");
  EXPECT_EQ(std::string(ToString(static_cast<TrackingStatus>(9))), "unknown");
}

TEST(KeyframeGraphTest, OnlyAResetAndALoadForgetLostMaps) {
  EXPECT_TRUE(ForgetsLostMaps(RevisionReason::kReset));
  EXPECT_TRUE(ForgetsLostMaps(RevisionReason::kLoad));
  for (const RevisionReason reason : {RevisionReason::kLocalBa, RevisionReason::kLoop,
                                      RevisionReason::kMerge, RevisionReason::kLost}) {
    EXPECT_FALSE(ForgetsLostMaps(reason)) << static_cast<int>(reason);
  }
}

TEST(KeyframeGraphTest, AnImageThatNobodyTrackedHasNoKeyframe) {
  const TrackedImage image;
  EXPECT_EQ(image.status, TrackingStatus::kInitializing);
  EXPECT_EQ(image.keyframe_id, kNoKeyframe);
}

}  // namespace
}  // namespace semantic_slam
