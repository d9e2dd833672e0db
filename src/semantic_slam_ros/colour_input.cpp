#include "semantic_slam_ros/colour_input.h"

#include <utility>

#include <ros/console.h>

#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {
namespace {

// As for pairs of images: less is disorder, and a single image says nothing.
constexpr double kJumpBackS = 1.0;
constexpr int kJumpBackImages = 3;

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
  early_.reset();
}

void ColourInput::OnColour(const ImageMessage& image, const std_msgs::Header& header) {
  if (paused_ || !HasStamp(header, "colour image", drops_)) return;
  const semantic_slam::Stamp stamp = ToStamp(header.stamp);
  if (!FollowTime(stamp)) return;
  on_image_(
      {stamp, FrameName(header.frame_id), image, timeline_, std::chrono::steady_clock::now()});
}

bool ColourInput::FollowTime(Stamp stamp) {
  if (newest_ && SecondsBetween(stamp, *newest_) > kJumpBackS) {
    early_images_ = early_ && stamp > *early_ ? early_images_ + 1 : 1;
    early_ = stamp;
    if (early_images_ == kJumpBackImages) {
      ROS_WARN("image stamps jumped back in time: a new recording begins");
      StartOver();
    }
  } else {
    early_.reset();
  }
  if (newest_ && stamp <= *newest_) {
    drops_.AddQuietly("out_of_order");
    return false;
  }
  newest_ = stamp;
  return true;
}

}  // namespace semantic_slam_ros
