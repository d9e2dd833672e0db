#include "semantic_slam_ros/node_health.h"

#include <utility>

#include "semantic_slam/common/check.h"

namespace semantic_slam_ros {

NodeHealth::NodeHealth(ros::NodeHandle nh, const ros::NodeHandle& private_nh,
                       const std::string& name, const DropCounter& drops,
                       std::function<void(Status&)> describe)
    : drops_(drops), describe_(std::move(describe)), updater_(nh, private_nh) {
  updater_.setHardwareID("none");
  updater_.add(name, this, &NodeHealth::Diagnose);
  const double period_s = updater_.getPeriod();
  semantic_slam::CheckInRange(private_nh.resolveName("diagnostic_period"), period_s, 0.1, 60.0);
  // By the wall's clock, and forced: update() waits for the simulated one, which may stand or jump.
  timer_ = nh.createWallTimer(ros::WallDuration(period_s),
                              [this](const ros::WallTimerEvent&) { updater_.force_update(); });
}

void NodeHealth::AddLatency(std::chrono::steady_clock::time_point received) {
  const std::chrono::duration<double, std::milli> latency =
      std::chrono::steady_clock::now() - received;
  std::lock_guard<std::mutex> lock(mutex_);
  latency_.Add(latency.count());
}

std::int64_t NodeHealth::processed() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return latency_.count();
}

void NodeHealth::Diagnose(Status& status) {
  semantic_slam::DurationHistogram latency;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    latency = latency_;
  }
  describe_(status);
  status.addf("latency median [ms]", "%.1f", latency.QuantileMs(0.5));
  status.addf("latency 95 % [ms]", "%.1f", latency.QuantileMs(0.95));
  for (const auto& [cause, count] : drops_.counts()) status.add("dropped: " + cause, count);
}

}  // namespace semantic_slam_ros
