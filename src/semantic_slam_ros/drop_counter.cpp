#include "semantic_slam_ros/drop_counter.h"

#include <ros/console.h>

namespace semantic_slam_ros {

namespace {

constexpr double kReportPeriodS = 5.0;

}  // namespace

void DropCounter::Add(const std::string& cause, const std::string& why) {
  const ros::WallTime now = ros::WallTime::now();
  std::size_t count = 0;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    Cause& entry = causes_[cause];
    count = ++entry.count;
    if (count > 1 && (now - entry.reported).toSec() < kReportPeriodS) return;
    entry.reported = now;
  }
  ROS_ERROR("%s (dropped: %s, %zu so far)", why.c_str(), cause.c_str(), count);
}

void DropCounter::AddQuietly(const std::string& cause, std::size_t count) {
  std::lock_guard<std::mutex> lock(mutex_);
  causes_[cause].count += count;
}

std::map<std::string, std::size_t> DropCounter::counts() const {
  std::lock_guard<std::mutex> lock(mutex_);
  std::map<std::string, std::size_t> counts;
  for (const auto& [cause, entry] : causes_) counts[cause] = entry.count;
  return counts;
}

}  // namespace semantic_slam_ros
