#include "semantic_slam_ros/simulation_pace.h"

#include <algorithm>

namespace semantic_slam_ros {

using semantic_slam::SecondsBetween;
using semantic_slam::Stamp;

namespace {

std::chrono::steady_clock::duration Seconds(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(seconds));
}

}  // namespace

bool SimulationPace::AwaitDue(Stamp stamp) {
  const Clock::time_point due = DueTime(stamp);
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_until(lock, due, [this] { return stopped_; });
  changed_.wait(lock, [this] { return stopped_ || !paused_; });
  return !stopped_;
}

bool SimulationPace::AwaitSeconds(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  return !changed_.wait_for(lock, Seconds(seconds), [this] { return stopped_; });
}

void SimulationPace::SetPaused(bool paused) {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    paused_ = paused;
  }
  changed_.notify_all();
}

void SimulationPace::Stop() {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
  }
  changed_.notify_all();
}

// Late is now: who is late does not hurry afterwards.
SimulationPace::Clock::time_point SimulationPace::DueTime(Stamp stamp) {
  const Clock::time_point now = Clock::now();
  Clock::time_point due = now;
  if (rate_ > 0.0 && last_stamp_ && *last_stamp_ < stamp) {
    due = std::max(now, last_due_ + Seconds(SecondsBetween(*last_stamp_, stamp) / rate_));
  }
  last_stamp_ = stamp;
  last_due_ = due;
  return due;
}

}  // namespace semantic_slam_ros
