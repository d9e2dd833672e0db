#pragma once

#include <functional>
#include <string>

#include <ros/node_handle.h>

#include "semantic_slam/common/throttle.h"
#include "semantic_slam_ros/colour_input.h"
#include "semantic_slam_ros/drop_counter.h"
#include "semantic_slam_ros/stage_worker.h"

namespace semantic_slam_ros {

struct ColourStageOptions {
  int queue_size = 1;         // images waiting for their turn; the oldest goes when another comes
  double min_period_s = 0.0;  // between two images that are looked at, by their stamps

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("queue_size", self.queue_size, 1, 1000);
    visit("min_period_s", self.min_period_s, 0.0, 3600.0);
  }
};

// Feeds the images of a colour camera, decoded, to work that may be slower than the camera and has
// a thread of its own. Counts what cannot be used under ColourInput's causes, late and bad_image.
class ColourStage {
 public:
  // `process` runs on the worker's thread; an InputError from it counts as bad_image, and it must
  // throw nothing else. While `is_wanted` says no, images are left alone, undecoded. Throws
  // ConfigError if an option is wrong. `drops` must outlive this.
  ColourStage(const ros::NodeHandle& nh, const ColourInputOptions& input_options,
              const ColourStageOptions& options, DropCounter& drops,
              std::function<bool()> is_wanted,
              std::function<void(const ColourMessage&, const ColourImage&)> process);

 private:
  void OnImage(ColourMessage message);

  const std::function<bool()> is_wanted_;
  semantic_slam::Throttle throttle_;
  StageWorker<ColourMessage> worker_;
  ColourInput input_;  // after the worker it feeds
};

}  // namespace semantic_slam_ros
