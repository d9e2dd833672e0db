#include "semantic_slam_ros/colour_input.h"

#include <utility>

#include <ros/console.h>

#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {
namespace {

constexpr double kJumpBackS = 1.0;  // as for pairs of images: less is disorder, not a new recording

}  // namespace

ColourInput::ColourInput(ros::NodeHandle nh, const ColourInputOptions& options, DropCounter& drops,
                         ImageCallback on_image)
    : drops_(drops), on_image_(std::move(on_image)) {
  sub_ = SubscribeToImages(
      nh, topics::kColour, kColourTransport, options.image_transport,
      [this](const ImageMessage& image, const auto& header) { OnColour(image, header); });
}

void ColourInput::StartOver() {
  ++timeline_;
  newest_.reset();
}

void ColourInput::OnColour(const ImageMessage& image, const std_msgs::Header& header) {
  if (paused_ || !HasStamp(header, "colour image", drops_)) return;
  const semantic_slam::Stamp stamp = ToStamp(header.stamp);
  if (!FollowTime(stamp)) return;
  on_image_(
      {stamp, FrameName(header.frame_id), image, timeline_, std::chrono::steady_clock::now()});
}

bool ColourInput::FollowTime(semantic_slam::Stamp stamp) {
  if (newest_ && SecondsBetween(stamp, *newest_) > kJumpBackS) {
    ROS_WARN("image stamps jumped back in time: a new recording begins");
    StartOver();
  }
  if (newest_ && stamp <= *newest_) {
    drops_.AddQuietly("out_of_order");
    return false;
  }
  newest_ = stamp;
  return true;
}

}  // namespace semantic_slam_ros
