#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/common/options.h"

namespace semantic_slam {

struct PoseJoinerOptions {
  int history = 600;  // tracked images remembered: a result may be that many images late
  int capacity = 20;  // results that may wait for the pose of their image

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("history", self.history, 1, 100000);
    visit("capacity", self.capacity, 1, 10000);
  }
};

// Joins what was found in an image (a cloud, detections, a scan) to what became of that image, by
// exact stamp: the way by which everything downstream gets its pose, never "the latest". Either may
// come first. Results whose pose never comes are dropped and counted.
//
// A tracked image that is over a second older than the one before, or that has another map_id,
// belongs to a new beginning: what was remembered from before is forgotten.
//
// Not thread-safe.
template <typename Payload>
class PoseJoiner {
 public:
  struct Joined {
    TrackedImage image;  // its status is kTracking
    Payload payload;
  };
  struct Counts {
    std::size_t no_pose = 0;      // no tracked image has that stamp
    std::size_t not_tracked = 0;  // the camera was lost at that image
    std::size_t overflow = 0;     // too many were waiting; the oldest had to go
  };

  // Throws ConfigError if an option is out of range.
  explicit PoseJoiner(const PoseJoinerOptions& options = {}) : options_(Validated(options)) {}

  // Returns what became certain, by ascending stamp: none or one as a rule.
  std::vector<Joined> AddPayload(Stamp stamp, Payload payload) {
    auto place = waiting_.end();
    while (place != waiting_.begin() && std::prev(place)->first > stamp) --place;
    waiting_.insert(place, {stamp, std::move(payload)});
    std::vector<Joined> joined = Settle();
    if (waiting_.size() > static_cast<std::size_t>(options_.capacity)) {
      waiting_.pop_front();
      ++counts_.overflow;
    }
    return joined;
  }

  std::vector<Joined> AddTracked(const TrackedImage& image) {
    if (!history_.empty()) {
      const TrackedImage& newest = history_.back();
      if (SecondsBetween(image.stamp, newest.stamp) > kJumpBackS || image.map_id != newest.map_id) {
        Forget();
      }
    }
    if (!history_.empty() && image.stamp <= history_.back().stamp) return {};
    history_.push_back(image);
    if (history_.size() > static_cast<std::size_t>(options_.history)) history_.pop_front();
    return Settle();
  }

  const Counts& counts() const { return counts_; }

 private:
  static constexpr double kJumpBackS = 1.0;

  // Payloads of the old map that still wait are older than any image of a new one, and are counted
  // when it comes; after a jump back they would wait for ever.
  void Forget() {
    history_.clear();
    counts_.no_pose += waiting_.size();
    waiting_.clear();
  }

  std::vector<Joined> Settle() {
    std::vector<Joined> joined;
    while (!waiting_.empty() && !history_.empty() &&
           waiting_.front().first <= history_.back().stamp) {
      auto& [stamp, payload] = waiting_.front();
      const TrackedImage* image = Find(stamp);
      if (image == nullptr) {
        ++counts_.no_pose;
      } else if (image->status != TrackingStatus::kTracking) {
        ++counts_.not_tracked;
      } else {
        joined.push_back({*image, std::move(payload)});
      }
      waiting_.pop_front();
    }
    return joined;
  }

  const TrackedImage* Find(Stamp stamp) const {
    const auto at = std::lower_bound(
        history_.begin(), history_.end(), stamp,
        [](const TrackedImage& image, Stamp wanted) { return image.stamp < wanted; });
    return at != history_.end() && at->stamp == stamp ? &*at : nullptr;
  }

  const PoseJoinerOptions options_;
  std::deque<TrackedImage> history_;                   // by ascending stamp
  std::deque<std::pair<Stamp, Payload>> waiting_;      // by ascending stamp
  Counts counts_;
};

}  // namespace semantic_slam
