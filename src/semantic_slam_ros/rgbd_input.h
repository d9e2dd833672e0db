#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>

#include "semantic_slam/camera/camera_model.h"
#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/dataset/image_pairer.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

// A colour image with the depth image of the same moment, still as messages: passing it on costs
// nothing, decoding it is left to the thread that wants the pixels.
struct RgbdMessages {
  semantic_slam::Stamp stamp;        // colour's
  semantic_slam::Stamp depth_stamp;
  std::string frame_id;              // colour's, without leading slash
  ImageMessage colour;
  ImageMessage depth;
  std::shared_ptr<const semantic_slam::CameraIntrinsics> intrinsics;
  int timeline = 0;  // grows when stamps jump back or StartOver() is called
  std::chrono::steady_clock::time_point received;

  // Throws InputError if an image is malformed or the two do not fit together.
  semantic_slam::RgbdImage Decode() const;
};

struct RgbdInputOptions {
  std::string image_transport = "raw";        // of colour: raw or compressed
  std::string depth_image_transport = "raw";  // raw or compressedDepth
  std::string camera_config;  // file with the calibration; empty: from camera_info

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("image_transport", self.image_transport);
    visit("depth_image_transport", self.depth_image_transport);
    visit("camera_config", self.camera_config);
  }
};

// Subscribes to an RGB-D camera and hands out pairs. Its callbacks only sort pointers. What cannot be
// used is counted under bad_stamp, bad_camera_info, no_camera_info, unpaired_colour, unpaired_depth
// and out_of_order. For one spinning thread.
class RgbdInput {
 public:
  using PairCallback = std::function<void(RgbdMessages)>;

  // Throws ConfigError if an option or the calibration file is wrong. `drops` must outlive this.
  RgbdInput(ros::NodeHandle nh, const RgbdInputOptions& options,
            const semantic_slam::ImagePairerOptions& pairer_options, DropCounter& drops,
            PairCallback on_pair);

  // Hands out the pairs that still wait to be sure that no image to come fits better: none will come.
  ~RgbdInput();

  // Pairs from now on belong to a new timeline: whoever keeps state from the old one forgets it.
  void StartOver() { ++timeline_; }

  // While paused, images are thrown away uncounted.
  void SetPaused(bool paused) { paused_ = paused; }

 private:
  using Clock = std::chrono::steady_clock;
  // What waits in the pairer: an image and when it came.
  struct Arrival {
    ImageMessage image;
    std::string frame_id;
    Clock::time_point received;
  };
  using Pairer = semantic_slam::ImagePairer<Arrival>;

  void OnColour(const ImageMessage& image, const std_msgs::Header& header);
  void OnDepth(const ImageMessage& image, const std_msgs::Header& header);
  void OnCameraInfo(const sensor_msgs::CameraInfoConstPtr& msg);
  bool IsUsable(const std_msgs::Header& header, const char* what);
  void HandOut(std::vector<Pairer::Pair> pairs);
  void Take(Pairer::Result result);
  void CountUnpaired();

  DropCounter& drops_;
  const PairCallback on_pair_;
  Pairer pairer_;
  Pairer::Counts counted_;  // what of the pairer's counts is in drops_ already
  std::shared_ptr<const semantic_slam::CameraIntrinsics> intrinsics_;
  int timeline_ = 0;
  bool paused_ = false;
  // Last, so that no callback finds a member gone.
  ros::Subscriber colour_sub_;
  ros::Subscriber depth_sub_;
  ros::Subscriber info_sub_;
};

}  // namespace semantic_slam_ros
