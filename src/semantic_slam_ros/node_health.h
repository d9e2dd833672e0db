#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// Tells on /diagnostics how a node is: what its owner says of its state, how long its work takes,
// and what it dropped, by cause. Once per ~diagnostic_period of the wall's clock, also while a
// simulated one stands. AddLatency() and processed() may be called from any thread.
class NodeHealth {
 public:
  using Status = diagnostic_updater::DiagnosticStatusWrapper;

  // `describe` sets the summary and adds what else is worth knowing; it is called from the spinning
  // thread, so an owner declares this after everything that `describe` reads. `name` is the
  // status's. `drops` must outlive this. Throws ConfigError if ~diagnostic_period is out of range.
  NodeHealth(ros::NodeHandle nh, const ros::NodeHandle& private_nh, const std::string& name,
             const DropCounter& drops, std::function<void(Status&)> describe);

  // Notes that something received at `received` is done now.
  void AddLatency(std::chrono::steady_clock::time_point received);

  // How often AddLatency() was called.
  std::int64_t processed() const;

 private:
  void Diagnose(Status& status);

  const DropCounter& drops_;
  const std::function<void(Status&)> describe_;
  mutable std::mutex mutex_;
  semantic_slam::DurationHistogram latency_;  // guarded by mutex_
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace semantic_slam_ros
