#include "semantic_slam_ros/simulation_pace.h"

#include <chrono>
#include <future>

#include <gtest/gtest.h>

namespace semantic_slam_ros {
namespace {

using semantic_slam::Stamp;
using Clock = std::chrono::steady_clock;

double SecondsFor(SimulationPace& pace, std::initializer_list<double> stamps) {
  const auto start = Clock::now();
  for (const double stamp : stamps) EXPECT_TRUE(pace.AwaitDue(Stamp::FromSeconds(stamp)));
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// It may take longer on a busy machine, but never shorter.
TEST(SimulationPaceTest, SimulatedTimeDoesNotRunAhead) {
  SimulationPace real_time(1.0), double_time(2.0);
  EXPECT_GE(SecondsFor(real_time, {100.0, 100.05, 100.1}), 0.099);
  EXPECT_GE(SecondsFor(double_time, {100.0, 100.05, 100.1}), 0.049);
}

TEST(SimulationPaceTest, WithoutARateNobodyWaits) {
  SimulationPace pace(0.0);
  // An hour of simulated time.
  EXPECT_LT(SecondsFor(pace, {100.0, 3700.0}), 60.0);
}

TEST(SimulationPaceTest, TimeThatJumpsBackIsDueNow) {
  SimulationPace pace(1.0);
  EXPECT_LT(SecondsFor(pace, {3700.0, 100.0}), 60.0);
}

TEST(SimulationPaceTest, StandsStillWhilePaused) {
  SimulationPace pace(0.0);
  pace.SetPaused(true);
  auto due = std::async(std::launch::async, [&] { return pace.AwaitDue(Stamp{1}); });
  EXPECT_EQ(due.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  pace.SetPaused(false);
  EXPECT_TRUE(due.get());
}

TEST(SimulationPaceTest, StoppingEndsEveryWait) {
  SimulationPace pace(0.0);
  pace.SetPaused(true);
  auto due = std::async(std::launch::async, [&] { return pace.AwaitDue(Stamp{1}); });
  pace.Stop();
  EXPECT_FALSE(due.get());
  EXPECT_FALSE(pace.AwaitDue(Stamp{2}));
  EXPECT_FALSE(pace.AwaitSeconds(600.0));
}

}  // namespace
}  // namespace semantic_slam_ros
