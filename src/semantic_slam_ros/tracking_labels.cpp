#include "semantic_slam_ros/tracking_labels.h"

#include <utility>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/image_subscription.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

using semantic_slam::LabelImageFate;
using semantic_slam::SemanticImageConstPtr;
using semantic_slam::VisualLocalization;

namespace {

// More can wait only while no image is tracked.
constexpr std::size_t kMaxWaiting = 4;

}  // namespace

TrackingLabels::TrackingLabels(ros::NodeHandle nh, const TrackingLabelOptions& options,
                               DropCounter& drops)
    : drops_(drops) {
  if (options.labels.empty()) return;
  vocabulary_ = semantic_slam::LabelVocabulary::Load(options.labels);
  left_out_ = semantic_slam::FindLabels("left_out_classes", options.left_out_classes, *vocabulary_);
  subscriber_ = nh.subscribe(topics::kSemanticImage, static_cast<int>(kMaxWaiting),
                             &TrackingLabels::OnSemanticImage, this);
}

void TrackingLabels::OnSemanticImage(const SemanticImageConstPtr& msg) {
  if (!HasStamp(msg->header, "semantic image", drops_)) return;
  std::lock_guard<std::mutex> lock(mutex_);
  waiting_.push_back(msg);
  if (waiting_.size() <= kMaxWaiting) return;
  waiting_.erase(waiting_.begin());
  drops_.AddQuietly("semantic_image_late");
}

void TrackingLabels::HandTo(VisualLocalization& localization) {
  std::vector<SemanticImageConstPtr> waiting;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    waiting.swap(waiting_);
  }
  for (const SemanticImageConstPtr& msg : waiting) Hand(msg, localization);
}

void TrackingLabels::Hand(const SemanticImageConstPtr& msg, VisualLocalization& localization) try {
  const semantic_slam::Segmentation segmentation = ToSegmentation(msg, *vocabulary_);
  switch (localization.AddLabels({segmentation.stamp, segmentation.labels[0], left_out_})) {
    case LabelImageFate::kUsed:
      return;
    case LabelImageFate::kOutOfOrder:
      return drops_.AddQuietly("semantic_image_out_of_order");
    case LabelImageFate::kLate:
      return drops_.AddQuietly("semantic_image_late");
    case LabelImageFate::kNotTracked:
      return drops_.AddQuietly("semantic_image_not_tracked");
    case LabelImageFate::kBadSize:
      return drops_.Add("bad_semantic_image", "semantic image: " + std::to_string(msg->width) +
                                                  " x " + std::to_string(msg->height) +
                                                  " px, but the camera has another size");
  }
} catch (const semantic_slam::InputError& e) {
  drops_.Add("bad_semantic_image", e.what());
}

}  // namespace semantic_slam_ros
