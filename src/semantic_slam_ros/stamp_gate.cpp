#include "semantic_slam_ros/stamp_gate.h"

namespace semantic_slam_ros {

using semantic_slam::Stamp;

void StampGate::Note(Stamp stamp) {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    noted_ = stamp;
  }
  changed_.notify_all();
}

bool StampGate::Await(Stamp stamp, std::chrono::steady_clock::duration limit) {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait_for(lock, limit, [&] { return closed_ || noted_ == stamp; });
  return !closed_ && noted_ == stamp;
}

void StampGate::Forget() {
  std::lock_guard<std::mutex> lock(mutex_);
  noted_.reset();
}

void StampGate::Close() {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
}

}  // namespace semantic_slam_ros
