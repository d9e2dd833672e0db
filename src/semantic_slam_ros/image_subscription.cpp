#include "semantic_slam_ros/image_subscription.h"

#include <utility>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {
namespace {

constexpr int kQueueSize = 10;  // per topic, for bursts; the callbacks take no time

template <typename Message>
ros::Subscriber Subscribe(ros::NodeHandle& nh, const std::string& topic, ImageCallback callback) {
  return nh.subscribe<Message>(
      topic, kQueueSize,
      [callback = std::move(callback)](const boost::shared_ptr<const Message>& msg) {
        callback(msg, msg->header);
      });
}

}  // namespace

ros::Subscriber SubscribeToImages(ros::NodeHandle& nh, const std::string& topic,
                                  const ImageTransport& transport, const std::string& choice,
                                  ImageCallback callback) {
  if (choice == "raw") return Subscribe<sensor_msgs::Image>(nh, topic, std::move(callback));
  if (choice == transport.compressed) {
    return Subscribe<sensor_msgs::CompressedImage>(nh, topic + "/" + transport.compressed,
                                                   std::move(callback));
  }
  throw semantic_slam::ConfigError("~" + std::string(transport.parameter) + " = " + choice +
                                   ", but must be raw or " + transport.compressed);
}

bool HasStamp(const std_msgs::Header& header, const char* what, DropCounter& drops) {
  if (!header.stamp.isZero()) return true;
  drops.Add("bad_stamp", std::string(what) + " has no stamp");
  return false;
}

}  // namespace semantic_slam_ros
