#include "semantic_slam/common/cpu_time.h"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace semantic_slam {
namespace {

// Takes that much CPU time on the calling thread, however busy the computer is.
void Work(double seconds) {
  const double end_s = ThreadCpuSeconds() + seconds;
  while (ThreadCpuSeconds() < end_s) continue;
}

TEST(CpuTimeTest, SleepTakesNone) {
  const double before_s = ThreadCpuSeconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_LT(ThreadCpuSeconds() - before_s, 0.05);  // falling asleep and waking up: microseconds
}

TEST(CpuTimeTest, TheProcessHasThatOfAllThreads) {
  const double thread_s = ThreadCpuSeconds(), process_s = ProcessCpuSeconds();
  std::thread other(Work, 0.05);
  Work(0.03);
  other.join();
  EXPECT_GE(ThreadCpuSeconds() - thread_s, 0.03);
  // 1 ms: the two clocks are read one after the other.
  EXPECT_GE(ProcessCpuSeconds() - process_s, 0.08 - 0.001);
}

}  // namespace
}  // namespace semantic_slam
