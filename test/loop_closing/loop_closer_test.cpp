#include "semantic_slam/loop_closing/loop_closer.h"

#include <gtest/gtest.h>

#include "loop_closing/two_visits.h"
#include "semantic_slam/map/map_contents.h"
#include "testing/expect_error.h"

namespace semantic_slam {
namespace {

class LoopCloserTest : public testing::Test {
 protected:
  std::unique_ptr<LoopCloser> Make(const LoopCloserOptions& options = LoopCloserOptions()) {
    return std::make_unique<LoopCloser>(options, SmallCamera(), visits_.map, visits_.index,
                                        poses_mutex_);
  }

  TwoVisits visits_;
  std::mutex poses_mutex_;
  StageTimer timer_;
};

TEST_F(LoopCloserTest, ClosesALoopAndAdjustsTheMap) {
  auto closer = Make();
  ASSERT_TRUE(closer->Process(TwoVisits::kLast, timer_));
  EXPECT_EQ(closer->loops(), 1u);
  closer->AdjustAll(timer_);
  for (KeyframeId id = TwoVisits::kVisit + TwoVisits::kAway; id <= TwoVisits::kLast; ++id) {
    // Now as good as the first visit: a pixel of this camera is 8 mm at 2 m.
    EXPECT_LT(visits_.Error(id), 0.01) << id;
  }
}

TEST_F(LoopCloserTest, ALoopIsClosedOnce) {
  auto closer = Make();
  ASSERT_TRUE(closer->Process(TwoVisits::kLast, timer_));
  EXPECT_FALSE(closer->Process(TwoVisits::kLast - 1, timer_));
  EXPECT_EQ(closer->loops(), 1u);
}

TEST_F(LoopCloserTest, RemembersKeyframesAndForgetsCulledOnes) {
  auto closer = Make();
  visits_.map.CullKeyframe(2);
  closer->Process(TwoVisits::kLast, timer_);
  const std::set<KeyframeId> known = visits_.index.Keyframes();
  EXPECT_EQ(known.count(TwoVisits::kLast), 1u);
  EXPECT_EQ(known.count(2), 0u);
}

TEST_F(LoopCloserTest, SwitchedOffItOnlyRemembers) {
  LoopCloserOptions options;
  options.loop_closing.enabled = false;
  auto closer = Make(options);
  EXPECT_FALSE(closer->Process(TwoVisits::kLast, timer_));
  EXPECT_EQ(visits_.index.Keyframes().count(TwoVisits::kLast), 1u);  // relocalization needs it
}

TEST_F(LoopCloserTest, ResetForgetsAllPlaces) {
  auto closer = Make();
  closer->Process(TwoVisits::kLast, timer_);
  visits_.map.Clear();
  closer->Reset(SmallCamera());
  EXPECT_TRUE(visits_.index.Keyframes().empty());
  EXPECT_FALSE(closer->Process(TwoVisits::kLast, timer_));  // it is gone
}

TEST_F(LoopCloserTest, KnowsTheKeyframesOfAMapThatWasLoaded) {
  auto closer = Make();
  const MapContents contents = visits_.map.Contents();
  visits_.map.Load(contents);
  closer->KnowMap();
  const std::set<KeyframeId> known = visits_.index.Keyframes();
  EXPECT_EQ(known.size(), contents.keyframes.size());
  for (const auto& entry : visits_.map.keyframes()) EXPECT_EQ(known.count(entry.first), 1u);
  // They may close loops: the last one is the loaded map's last.
  EXPECT_TRUE(closer->Process(visits_.map.keyframes().rbegin()->first, timer_));
}

TEST_F(LoopCloserTest, RefusesOptionsByName) {
  LoopCloserOptions options;
  options.loop_closing.min_gap_keyframes = 0;
  EXPECT_EQ(MessageOf<ConfigError>([&] { Make(options); }).substr(0, 21), "min_gap_keyframes = 0");
}

}  // namespace
}  // namespace semantic_slam
