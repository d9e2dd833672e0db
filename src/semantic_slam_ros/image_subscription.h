#pragma once

#include <functional>
#include <string>

#include <ros/node_handle.h>
#include <std_msgs/Header.h>

#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// How the images of a topic come: raw, or compressed under the topic's name with "/compressed" or
// "/compressedDepth" behind it. image_transport is not asked, because its plugins decode inside the
// callback.
struct ImageTransport {
  const char* parameter;   // that chooses it, for messages to the operator
  const char* compressed;  // what the choice is called, and the topic's ending
};
constexpr ImageTransport kColourTransport{"image_transport", "compressed"};
constexpr ImageTransport kDepthTransport{"depth_image_transport", "compressedDepth"};

using ImageCallback = std::function<void(const ImageMessage&, const std_msgs::Header&)>;

// Subscribes to the images of `topic` as `choice` says: "raw" or transport.compressed. The callback
// gets the message undecoded. Throws ConfigError if the choice is neither.
ros::Subscriber SubscribeToImages(ros::NodeHandle& nh, const std::string& topic,
                                  const ImageTransport& transport, const std::string& choice,
                                  ImageCallback callback);

// False if a message has no stamp, which is counted under bad_stamp; `what` names the message.
bool HasStamp(const std_msgs::Header& header, const char* what, DropCounter& drops);

}  // namespace semantic_slam_ros
