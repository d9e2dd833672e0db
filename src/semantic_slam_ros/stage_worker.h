#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "semantic_slam/common/worker.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// A Worker that keeps up with a sensor: the newest items matter, and an old one that had to go
// because the work was still busy is counted under `late`. Push from one thread.
template <typename T>
class StageWorker {
 public:
  // `drops` must outlive this; `handle` must not throw.
  StageWorker(int capacity, DropCounter& drops, std::function<void(T)> handle)
      : drops_(drops),
        worker_(static_cast<std::size_t>(capacity), semantic_slam::WhenFull::kDropOldest,
                std::move(handle)) {}

  void Push(T item) {
    worker_.Push(std::move(item));
    const std::size_t late = worker_.dropped();
    if (late > counted_) drops_.AddQuietly("late", late - counted_);
    counted_ = late;
  }

 private:
  DropCounter& drops_;
  std::size_t counted_ = 0;
  semantic_slam::Worker<T> worker_;
};

}  // namespace semantic_slam_ros
