#include "semantic_slam_ros/rgbd_input.h"

#include <algorithm>
#include <utility>

#include <ros/console.h>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::CameraIntrinsics;
using semantic_slam::InputError;
using semantic_slam::RgbdImage;

namespace {

constexpr int kInfoQueueSize = 10;

}  // namespace

RgbdImage RgbdMessages::Decode() const {
  ColourImage colour_image = ToColour(colour);
  RgbdImage image{stamp, depth_stamp, std::move(colour_image.pixels), colour_image.order,
                  ToDepthMetres(depth)};
  CheckRgbdImage(image);
  return image;
}

RgbdInput::RgbdInput(ros::NodeHandle nh, const RgbdInputOptions& options,
                     const semantic_slam::ImagePairerOptions& pairer_options, DropCounter& drops,
                     PairCallback on_pair)
    : drops_(drops), on_pair_(std::move(on_pair)), pairer_(pairer_options) {
  colour_sub_ = SubscribeToImages(
      nh, topics::kColour, kColourTransport, options.image_transport,
      [this](const ImageMessage& image, const auto& header) { OnColour(image, header); });
  depth_sub_ = SubscribeToImages(
      nh, topics::kDepth, kDepthTransport, options.depth_image_transport,
      [this](const ImageMessage& image, const auto& header) { OnDepth(image, header); });
  if (options.camera_config.empty()) {
    info_sub_ = nh.subscribe(topics::kCameraInfo, kInfoQueueSize, &RgbdInput::OnCameraInfo, this);
  } else {
    const auto config = semantic_slam::LoadCameraConfig(options.camera_config);
    intrinsics_ = std::make_shared<const CameraIntrinsics>(config.intrinsics);
    ROS_INFO("calibration from %s", options.camera_config.c_str());
  }
}

RgbdInput::~RgbdInput() {
  for (ros::Subscriber* sub : {&colour_sub_, &depth_sub_, &info_sub_}) sub->shutdown();
  HandOut(pairer_.Flush());
}

void RgbdInput::OnColour(const ImageMessage& image, const std_msgs::Header& header) {
  if (paused_ || !IsUsable(header, "colour image")) return;
  Take(pairer_.AddColour(ToStamp(header.stamp),
                            {image, FrameName(header.frame_id), Clock::now()}));
}

void RgbdInput::OnDepth(const ImageMessage& image, const std_msgs::Header& header) {
  if (paused_ || !IsUsable(header, "depth image")) return;
  Take(pairer_.AddDepth(ToStamp(header.stamp), {image, "", Clock::now()}));
}

void RgbdInput::OnCameraInfo(const sensor_msgs::CameraInfoConstPtr& msg) {
  try {
    const CameraIntrinsics intrinsics = ToIntrinsics(*msg);
    if (intrinsics_ != nullptr && *intrinsics_ == intrinsics) return;
    intrinsics_ = std::make_shared<const CameraIntrinsics>(intrinsics);
  } catch (const InputError& e) {
    drops_.Add("bad_camera_info", e.what());
  }
}

bool RgbdInput::IsUsable(const std_msgs::Header& header, const char* what) {
  if (!HasStamp(header, what, drops_)) return false;
  if (intrinsics_ == nullptr) {
    drops_.Add("no_camera_info", std::string(what) + " came, but no usable camera_info before it");
    return false;
  }
  return true;
}

void RgbdInput::Take(Pairer::Result result) {
  if (result.jumped_back) {
    ROS_WARN("image stamps jumped back in time: the map is forgotten, a new one begins");
    StartOver();
  }
  HandOut(std::move(result.pairs));
}

void RgbdInput::HandOut(std::vector<Pairer::Pair> pairs) {
  for (Pairer::Pair& pair : pairs) {
    on_pair_({pair.stamp, pair.depth_stamp, std::move(pair.colour.frame_id),
              std::move(pair.colour.image), std::move(pair.depth.image), intrinsics_, timeline_,
              std::max(pair.colour.received, pair.depth.received)});
  }
  CountUnpaired();
}

void RgbdInput::CountUnpaired() {
  const Pairer::Counts counts = pairer_.counts();
  const auto count = [this](const char* cause, std::size_t now, std::size_t before) {
    if (now > before) drops_.AddQuietly(cause, now - before);
  };
  count("unpaired_colour", counts.unpaired_colour, counted_.unpaired_colour);
  count("unpaired_depth", counts.unpaired_depth, counted_.unpaired_depth);
  count("out_of_order", counts.out_of_order, counted_.out_of_order);
  counted_ = counts;
}

}  // namespace semantic_slam_ros
