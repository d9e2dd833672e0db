#pragma once

#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/worker.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// What a node that keeps a map does on a thread of its own: it moves the map to where the keyframes
// are now, takes in what was seen, and publishes; in this order. Of graphs only the newest matters,
// and none is lost to a burst of images. Of what was seen the oldest has to go when more than
// `capacity` wait, and that is counted under `late`. All methods are thread-safe.
template <typename Seen>
class MapWorker {
 public:
  // Called on the worker's thread; none may throw.
  struct Handlers {
    std::function<void(const semantic_slam::KeyframeGraph&)> follow_graph;
    std::function<void(const Seen&)> take_in;
    std::function<void()> publish;
  };

  // `drops` must outlive this.
  MapWorker(int capacity, DropCounter& drops, Handlers handlers)
      : capacity_(static_cast<std::size_t>(capacity)),
        drops_(drops),
        handlers_(std::move(handlers)),
        worker_(1, semantic_slam::WhenFull::kDropOldest, [this](Wake) { Work(); }) {}

  void Add(std::vector<Seen> seen) {
    if (seen.empty()) return;
    std::size_t late = 0;
    {
      std::lock_guard<std::mutex> lock(mutex_);
      for (Seen& each : seen) waiting_.push_back(std::move(each));
      for (; waiting_.size() > capacity_; ++late) waiting_.pop_front();
    }
    if (late > 0) drops_.AddQuietly("late", late);
    worker_.Push({});
  }

  void Follow(semantic_slam::KeyframeGraph graph) {
    {
      std::lock_guard<std::mutex> lock(mutex_);
      newest_graph_ = std::move(graph);
    }
    worker_.Push({});
  }

  // Publishes as soon as what is being worked on is in the map.
  void Publish() {
    publish_is_due_ = true;
    worker_.Push({});
  }

  // Forgets what was seen and still waits, uncounted; a waiting graph stays.
  void Clear() {
    std::lock_guard<std::mutex> lock(mutex_);
    waiting_.clear();
  }

 private:
  struct Wake {};  // there may be something to do

  void Work() {
    std::deque<Seen> seen;
    std::optional<semantic_slam::KeyframeGraph> graph;
    {
      std::lock_guard<std::mutex> lock(mutex_);
      seen.swap(waiting_);
      graph.swap(newest_graph_);
    }
    if (graph) handlers_.follow_graph(*graph);
    for (const Seen& each : seen) handlers_.take_in(each);
    if (publish_is_due_.exchange(false)) handlers_.publish();
  }

  const std::size_t capacity_;
  DropCounter& drops_;
  const Handlers handlers_;
  std::mutex mutex_;
  std::deque<Seen> waiting_;                                  // guarded by mutex_
  std::optional<semantic_slam::KeyframeGraph> newest_graph_;  // guarded by mutex_
  std::atomic<bool> publish_is_due_{false};
  semantic_slam::Worker<Wake> worker_;  // last: joined before anything it uses goes
};

}  // namespace semantic_slam_ros
