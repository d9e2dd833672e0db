#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include <ros/node_handle.h>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// A colour image, still as a message: passing it on costs nothing, decoding it is left to the
// thread that wants the pixels.
struct ColourMessage {
  semantic_slam::Stamp stamp;
  std::string frame_id;  // without leading slash
  ImageMessage image;
  int timeline = 0;  // grows when stamps jump back or StartOver() is called
  std::chrono::steady_clock::time_point received;

  // Throws InputError if the image is malformed.
  ColourImage Decode() const { return ToColour(image); }
};

struct ColourInputOptions {
  std::string image_transport = "raw";  // raw or compressed

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("image_transport", self.image_transport);
  }
};

// Subscribes to a colour camera and hands out its images by ascending stamp; three images in a row
// that are over a second older than one before begin a new timeline. What cannot be used is counted
// under bad_stamp and out_of_order. For one spinning thread.
class ColourInput {
 public:
  using ImageCallback = std::function<void(ColourMessage)>;

  // Throws ConfigError if an option is wrong. `drops` must outlive this.
  ColourInput(ros::NodeHandle nh, const ColourInputOptions& options, DropCounter& drops,
              ImageCallback on_image);

  // Images from now on belong to a new timeline: whoever keeps state from the old one forgets it.
  void StartOver();

  // While paused, images are thrown away uncounted.
  void SetPaused(bool paused) { paused_ = paused; }

 private:
  void OnColour(const ImageMessage& image, const std_msgs::Header& header);
  bool FollowTime(semantic_slam::Stamp stamp);

  DropCounter& drops_;
  const ImageCallback on_image_;
  std::optional<semantic_slam::Stamp> newest_;
  std::optional<semantic_slam::Stamp>
      early_;             // of the last image, if that was far older than newest_
  int early_images_ = 0;  // how many of those came one after another
  int timeline_ = 0;
  bool paused_ = false;
  ros::Subscriber sub_;  // last, so that no callback finds a member gone
};

}  // namespace semantic_slam_ros
