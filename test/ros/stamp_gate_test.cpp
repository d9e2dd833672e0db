#include "semantic_slam_ros/stamp_gate.h"

#include <chrono>
#include <future>

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::Stamp;

constexpr std::chrono::milliseconds kShort{10};
constexpr std::chrono::seconds kLong{20};

TEST(StampGateTest, PassesAtOnceIfTheAnswerIsThere) {
  StampGate gate;
  gate.Note(Stamp{7});
  EXPECT_TRUE(gate.Await(Stamp{7}, kShort));
}

TEST(StampGateTest, AnotherStampIsNoAnswer) {
  StampGate gate;
  gate.Note(Stamp{6});
  EXPECT_FALSE(gate.Await(Stamp{7}, kShort));
}

TEST(StampGateTest, WaitsForTheAnswer) {
  StampGate gate;
  auto passed = std::async(std::launch::async, [&] { return gate.Await(Stamp{7}, kLong); });
  gate.Note(Stamp{6});
  gate.Note(Stamp{7});
  EXPECT_TRUE(passed.get());
}

TEST(StampGateTest, ForgetsWhatWasNoted) {
  StampGate gate;
  gate.Note(Stamp{7});
  gate.Forget();
  EXPECT_FALSE(gate.Await(Stamp{7}, kShort));
}

TEST(StampGateTest, NobodyWaitsAtAClosedGate) {
  StampGate gate;
  auto passed = std::async(std::launch::async, [&] { return gate.Await(Stamp{7}, kLong); });
  gate.Close();
  EXPECT_FALSE(passed.get());
  gate.Note(Stamp{7});
  EXPECT_FALSE(gate.Await(Stamp{7}, kLong));
}

}  // namespace
}  // namespace semantic_slam_ros
