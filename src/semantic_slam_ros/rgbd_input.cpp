#include "semantic_slam_ros/rgbd_input.h"

#include <algorithm>
#include <utility>

#include <ros/console.h>

#include "semantic_slam/camera/camera_config.h"
#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::CameraIntrinsics;
using semantic_slam::ConfigError;
using semantic_slam::InputError;
using semantic_slam::RgbdImage;

namespace {

constexpr int kQueueSize = 10;  // per topic, for bursts; the callbacks take no time

// Whether the images come compressed. Throws ConfigError if `transport` is neither.
bool IsCompressed(const char* parameter, const std::string& transport, const char* compressed) {
  if (transport == compressed) return true;
  if (transport == "raw") return false;
  throw ConfigError("~" + std::string(parameter) + " = " + transport + ", but must be raw or " +
                    compressed);
}

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
  using sensor_msgs::CompressedImage;
  using sensor_msgs::Image;
  const std::string colour = topics::kColour, depth = topics::kDepth;
  if (IsCompressed("image_transport", options.image_transport, "compressed")) {
    colour_sub_ = nh.subscribe(colour + "/compressed", kQueueSize,
                               &RgbdInput::OnColour<CompressedImage>, this);
  } else {
    colour_sub_ = nh.subscribe(colour, kQueueSize, &RgbdInput::OnColour<Image>, this);
  }
  if (IsCompressed("depth_image_transport", options.depth_image_transport, "compressedDepth")) {
    depth_sub_ = nh.subscribe(depth + "/compressedDepth", kQueueSize,
                              &RgbdInput::OnDepth<CompressedImage>, this);
  } else {
    depth_sub_ = nh.subscribe(depth, kQueueSize, &RgbdInput::OnDepth<Image>, this);
  }
  if (options.camera_config.empty()) {
    info_sub_ = nh.subscribe(topics::kCameraInfo, kQueueSize, &RgbdInput::OnCameraInfo, this);
  } else {
    const auto config = semantic_slam::LoadCameraConfig(options.camera_config);
    intrinsics_ = std::make_shared<const CameraIntrinsics>(config.intrinsics);
    ROS_INFO("calibration from %s", options.camera_config.c_str());
  }
}

template <typename Message>
void RgbdInput::OnColour(const boost::shared_ptr<const Message>& msg) {
  if (paused_ || !IsUsable(msg->header, "colour image")) return;
  HandOut(pairer_.AddColour(ToStamp(msg->header.stamp),
                            {msg, FrameName(msg->header.frame_id), Clock::now()}));
}

template <typename Message>
void RgbdInput::OnDepth(const boost::shared_ptr<const Message>& msg) {
  if (paused_ || !IsUsable(msg->header, "depth image")) return;
  HandOut(pairer_.AddDepth(ToStamp(msg->header.stamp), {msg, "", Clock::now()}));
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
  if (header.stamp.isZero()) {
    drops_.Add("bad_stamp", std::string(what) + " has no stamp");
    return false;
  }
  if (intrinsics_ == nullptr) {
    drops_.Add("no_camera_info", std::string(what) + " came, but no usable camera_info before it");
    return false;
  }
  return true;
}

void RgbdInput::HandOut(Pairer::Result result) {
  if (result.jumped_back) {
    ROS_WARN("image stamps jumped back in time: the map is forgotten, a new one begins");
    StartOver();
  }
  for (Pairer::Pair& pair : result.pairs) {
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
