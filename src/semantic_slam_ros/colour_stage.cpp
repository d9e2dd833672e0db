#include "semantic_slam_ros/colour_stage.h"

#include <utility>

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

ColourStage::ColourStage(const ros::NodeHandle& nh, const ColourInputOptions& input_options,
                         const ColourStageOptions& options, DropCounter& drops,
                         std::function<bool()> is_wanted,
                         std::function<void(const ColourMessage&, const ColourImage&)> process)
    : is_wanted_(std::move(is_wanted)),
      throttle_(options.min_period_s),
      worker_(options.queue_size, drops,
              [&drops, process = std::move(process)](const ColourMessage& message) {
                try {
                  process(message, message.Decode());
                } catch (const semantic_slam::InputError& e) {
                  drops.Add("bad_image", e.what());
                }
              }),
      input_(nh, input_options, drops,
             [this](ColourMessage message) { OnImage(std::move(message)); }) {}

void ColourStage::OnImage(ColourMessage message) {
  if (is_wanted_() && throttle_.IsDue(message.stamp)) worker_.Push(std::move(message));
}

}  // namespace semantic_slam_ros
