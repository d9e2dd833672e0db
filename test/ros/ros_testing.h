#pragma once

#include <map>
#include <string>
#include <vector>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

// What the tests of nodes share.

namespace semantic_slam_ros {

// Spins until `done()` or the limit; the verdict belongs to the caller.
template <typename Done>
bool SpinUntil(Done done, double limit_s) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(limit_s);
  while (ros::ok() && ros::WallTime::now() < end && !done()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
  }
  return done();
}

// Keeps the messages of one topic.
template <typename Message>
class Listener {
 public:
  Listener(ros::NodeHandle& nh, const std::string& topic)
      : sub_(nh.subscribe<Message>(
            topic, 1000, [this](const boost::shared_ptr<const Message>& msg) {
              last_ = msg;
              ++count_;
            })) {}

  bool connected() const { return sub_.getNumPublishers() > 0; }
  int count() const { return count_; }
  // nullptr before the first message.
  const boost::shared_ptr<const Message>& last() const { return last_; }
  void Forget() {
    last_.reset();
    count_ = 0;
  }

 private:
  boost::shared_ptr<const Message> last_;
  int count_ = 0;
  ros::Subscriber sub_;
};

// The value under `key` of the first status that has it; empty if none does.
inline std::string DiagnosticValue(const diagnostic_msgs::DiagnosticArray& array,
                                   const std::string& key) {
  for (const auto& status : array.status) {
    for (const auto& value : status.values) {
      if (value.key == key) return value.value;
    }
  }
  return "";
}

}  // namespace semantic_slam_ros
