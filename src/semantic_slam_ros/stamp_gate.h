#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam_ros {

// Lets one thread wait until another has got the answer to what was sent at a stamp. Thread-safe.
class StampGate {
 public:
  // The answer for `stamp` is there.
  void Note(semantic_slam::Stamp stamp);

  // Waits for it, if it is not there yet. False if the limit of wall time ran out first or the gate
  // was closed.
  bool Await(semantic_slam::Stamp stamp, std::chrono::steady_clock::duration limit);

  // What was noted so far does not count any more: stamps begin anew.
  void Forget();

  // Nobody waits any more, now and later.
  void Close();

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<semantic_slam::Stamp> noted_;  // guarded by mutex_; the last one
  bool closed_ = false;                        // guarded by mutex_
};

}  // namespace semantic_slam_ros
