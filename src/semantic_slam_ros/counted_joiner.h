#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "semantic_slam/common/pose_joiner.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// A PoseJoiner whose losses are counted among a node's drops, under no_pose and not_tracked. For
// one spinning thread.
template <typename Payload>
class CountedJoiner {
 public:
  using Joined = typename semantic_slam::PoseJoiner<Payload>::Joined;

  // Throws ConfigError if an option is out of range. `drops` must outlive this.
  CountedJoiner(const semantic_slam::PoseJoinerOptions& options, DropCounter& drops)
      : joiner_(options), drops_(drops) {}

  // Both as PoseJoiner's.
  std::vector<Joined> AddPayload(semantic_slam::Stamp stamp, Payload payload) {
    return Counted(joiner_.AddPayload(stamp, std::move(payload)));
  }
  std::vector<Joined> AddTracked(const semantic_slam::TrackedImage& image) {
    return Counted(joiner_.AddTracked(image));
  }

 private:
  using Counts = typename semantic_slam::PoseJoiner<Payload>::Counts;

  std::vector<Joined> Counted(std::vector<Joined> joined) {
    const Counts& now = joiner_.counts();
    Count("no_pose", now.no_pose + now.overflow, counted_.no_pose + counted_.overflow);
    Count("not_tracked", now.not_tracked, counted_.not_tracked);
    counted_ = now;
    return joined;
  }
  void Count(const char* cause, std::size_t now, std::size_t before) {
    if (now > before) drops_.AddQuietly(cause, now - before);
  }

  semantic_slam::PoseJoiner<Payload> joiner_;
  Counts counted_;  // what of the joiner's counts is in drops_ already
  DropCounter& drops_;
};

}  // namespace semantic_slam_ros
