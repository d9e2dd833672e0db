#include "semantic_slam_ros/counted_joiner.h"

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::Stamp;
using semantic_slam::TrackedImage;
using semantic_slam::TrackingStatus;

TrackedImage ImageAt(std::int64_t ns, TrackingStatus status = TrackingStatus::kTracking) {
  TrackedImage image;
  image.stamp = Stamp{ns};
  image.status = status;
  return image;
}

TEST(CountedJoinerTest, JoinsWithoutCounting) {
  DropCounter drops;
  CountedJoiner<int> joiner({}, drops);
  EXPECT_TRUE(joiner.AddPayload(Stamp{10}, 1).empty());
  const auto joined = joiner.AddTracked(ImageAt(10));
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].payload, 1);
  EXPECT_TRUE(drops.counts().empty());
}

TEST(CountedJoinerTest, CountsWhatFindsNoPose) {
  DropCounter drops;
  semantic_slam::PoseJoinerOptions options;
  options.capacity = 2;
  CountedJoiner<int> joiner(options, drops);
  for (int i = 1; i <= 3; ++i) joiner.AddPayload(Stamp{10 * i}, i);  // one overflows
  joiner.AddTracked(ImageAt(25));                                    // the second is passed by
  joiner.AddTracked(ImageAt(30, TrackingStatus::kLost));
  EXPECT_EQ(drops.counts().at("no_pose"), 2u);
  EXPECT_EQ(drops.counts().at("not_tracked"), 1u);
}

}  // namespace
}  // namespace semantic_slam_ros
