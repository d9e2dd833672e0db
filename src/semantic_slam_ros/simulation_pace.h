#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam_ros {

// Keeps simulated time from running ahead of the wall's, and still while it is paused. Thread-safe.
class SimulationPace {
 public:
  // `rate` is simulated over real time, at most; 0: as fast as it can.
  explicit SimulationPace(double rate) : rate_(rate) {}

  // Waits until simulated time may have come to `stamp`. Time that was lost is not made up for.
  // False if it was stopped.
  bool AwaitDue(semantic_slam::Stamp stamp);

  // Waits so long of the wall's time. False if it was stopped.
  bool AwaitSeconds(double seconds);

  void SetPaused(bool paused);

  // Nobody waits any more, now and later.
  void Stop();

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point DueTime(semantic_slam::Stamp stamp);

  const double rate_;
  std::optional<semantic_slam::Stamp> last_stamp_;  // for the waiting thread
  Clock::time_point last_due_;                      // likewise
  std::mutex mutex_;
  std::condition_variable changed_;
  bool paused_ = false;   // guarded by mutex_
  bool stopped_ = false;  // guarded by mutex_
};

}  // namespace semantic_slam_ros
