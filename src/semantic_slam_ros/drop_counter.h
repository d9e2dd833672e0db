#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <string>

#include <ros/time.h>

namespace semantic_slam_ros {

// Counts the messages a node could not use, by cause, and says so on the console: at most once per
// cause and five seconds. Thread-safe.
class DropCounter {
 public:
  // `cause` is a short name for /diagnostics, "bad_depth" say; `why` one line for the console.
  void Add(const std::string& cause, const std::string& why);

  // The same without a word, for what is no fault.
  void AddQuietly(const std::string& cause, std::size_t count = 1);

  std::map<std::string, std::size_t> counts() const;

 private:
  struct Cause {
    std::size_t count = 0;
    ros::WallTime reported;
  };

  mutable std::mutex mutex_;
  std::map<std::string, Cause> causes_;  // guarded by mutex_
};

}  // namespace semantic_slam_ros
