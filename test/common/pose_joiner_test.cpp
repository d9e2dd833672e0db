#include "semantic_slam/common/pose_joiner.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

using Joiner = PoseJoiner<std::string>;

Stamp Seconds(double seconds) {
  return Stamp::FromSeconds(seconds);
}

TrackedImage Tracked(double seconds, int map_id = 0) {
  TrackedImage image;
  image.stamp = Seconds(seconds);
  image.status = TrackingStatus::kTracking;
  image.map_id = map_id;
  image.keyframe_id = 1;
  return image;
}

TrackedImage Lost(double seconds) {
  TrackedImage image = Tracked(seconds);
  image.status = TrackingStatus::kLost;
  return image;
}

std::string Names(const std::vector<Joiner::Joined>& joined) {
  std::string names;
  for (const auto& [image, payload] : joined) names += payload;
  return names;
}

TEST(PoseJoinerTest, JoinsByExactStampWhicheverComesFirst) {
  Joiner joiner;
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.0), "a")), "");
  const auto joined = joiner.AddTracked(Tracked(1.0));
  EXPECT_EQ(Names(joined), "a");
  EXPECT_EQ(joined[0].image.stamp, Seconds(1.0));
  EXPECT_EQ(Names(joiner.AddTracked(Tracked(1.1))), "");
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.1), "b")), "b");
}

TEST(PoseJoinerTest, WaitsUntilTrackingHasComeThatFar) {
  Joiner joiner;
  joiner.AddTracked(Tracked(1.0));
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.2), "late")), "");
  EXPECT_EQ(Names(joiner.AddTracked(Tracked(1.1))), "");
  EXPECT_EQ(Names(joiner.AddTracked(Tracked(1.2))), "late");
  EXPECT_EQ(joiner.counts().no_pose, 0u);
}

TEST(PoseJoinerTest, CountsWhatHasNoImageOfItsStamp) {
  Joiner joiner;
  joiner.AddTracked(Tracked(1.0));
  joiner.AddTracked(Tracked(1.1));
  EXPECT_EQ(Names(joiner.AddPayload(Stamp{Seconds(1.0).ns + 1}, "between")), "");
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(0.5), "before")), "");
  EXPECT_EQ(joiner.counts().no_pose, 2u);
}

TEST(PoseJoinerTest, CountsWhatWasSeenWhileLost) {
  Joiner joiner;
  joiner.AddTracked(Lost(1.0));
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.0), "a")), "");
  EXPECT_EQ(joiner.counts().not_tracked, 1u);
}

TEST(PoseJoinerTest, HandsOutByAscendingStamp) {
  Joiner joiner;
  joiner.AddPayload(Seconds(1.2), "c");
  joiner.AddPayload(Seconds(1.0), "a");
  joiner.AddPayload(Seconds(1.1), "b");
  std::string names = Names(joiner.AddTracked(Tracked(1.0)));
  names += Names(joiner.AddTracked(Tracked(1.1)));
  names += Names(joiner.AddTracked(Tracked(1.2)));
  EXPECT_EQ(names, "abc");
}

TEST(PoseJoinerTest, LetsTheOldestGoWhenTooManyWait) {
  PoseJoinerOptions options;
  options.capacity = 2;
  Joiner joiner(options);
  for (const char* name : {"a", "b", "c"}) joiner.AddPayload(Seconds(name[0] - 'a' + 1.0), name);
  EXPECT_EQ(joiner.counts().overflow, 1u);
  EXPECT_EQ(Names(joiner.AddTracked(Tracked(1.0))), "");
  EXPECT_EQ(Names(joiner.AddTracked(Tracked(2.0))), "b");
  EXPECT_EQ(Names(joiner.AddTracked(Tracked(3.0))), "c");
}

TEST(PoseJoinerTest, RemembersOnlySoManyImages) {
  PoseJoinerOptions options;
  options.history = 2;
  Joiner joiner(options);
  for (int i = 0; i < 3; ++i) joiner.AddTracked(Tracked(1.0 + i));
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.0), "forgotten")), "");
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(2.0), "known")), "known");
  EXPECT_EQ(joiner.counts().no_pose, 1u);
}

TEST(PoseJoinerTest, IgnoresImagesOutOfOrder) {
  Joiner joiner;
  joiner.AddTracked(Tracked(1.5));
  joiner.AddTracked(Tracked(1.0));
  joiner.AddTracked(Lost(1.5));
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.0), "a")), "");
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.5), "b")), "b") << "the first state counts";
}

TEST(PoseJoinerTest, BeginsAgainWhenTimeJumpsBack) {
  Joiner joiner;
  joiner.AddTracked(Tracked(100.0));
  joiner.AddPayload(Seconds(100.1), "of the old recording");
  joiner.AddTracked(Tracked(10.0));
  EXPECT_EQ(joiner.counts().no_pose, 1u);
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(10.0), "new")), "new");
  joiner.AddTracked(Tracked(10.1));
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(10.1), "newer")), "newer");
}

TEST(PoseJoinerTest, ForgetsTheOldMapsImagesWithTheMap) {
  Joiner joiner;
  joiner.AddTracked(Tracked(1.0, 0));
  joiner.AddTracked(Tracked(1.1, 1));
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.0), "old map")), "");
  EXPECT_EQ(joiner.counts().no_pose, 1u);
  EXPECT_EQ(Names(joiner.AddPayload(Seconds(1.1), "new map")), "new map");
}

TEST(PoseJoinerTest, TakesPayloadsThatCannotBeCopied) {
  PoseJoiner<std::unique_ptr<int>> joiner;
  joiner.AddPayload(Seconds(1.0), std::make_unique<int>(5));
  const auto joined = joiner.AddTracked(Tracked(1.0));
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(*joined[0].payload, 5);
}

TEST(PoseJoinerTest, RefusesOptionsOutOfRange) {
  PoseJoinerOptions options;
  options.capacity = 0;
  EXPECT_THROW(Joiner{options}, ConfigError);
}

}  // namespace
}  // namespace semantic_slam
