#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <semantic_slam/SemanticImage.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam_ros/drop_counter.h"

namespace semantic_slam_ros {

struct TrackingLabelOptions {
  std::string labels;  // file with the label vocabulary; empty: tracking does without semantics
  std::string left_out_classes = "person";  // whose features tracking does not use; by commas

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("labels", self.labels);
    visit("left_out_classes", self.left_out_classes);
  }
};

// Semantic images on their way to tracking: the callback keeps the latest ones, who tracks hands
// them on. Counts what cannot be used under bad_semantic_image, semantic_image_late,
// semantic_image_out_of_order and semantic_image_not_tracked.
class TrackingLabels {
 public:
  // Throws ConfigError if the vocabulary cannot be read or knows no class of a name. `drops` must
  // outlive this.
  TrackingLabels(ros::NodeHandle nh, const TrackingLabelOptions& options, DropCounter& drops);

  // Gives what has come to `localization`. To be called on the thread that tracks, before each
  // image.
  void HandTo(semantic_slam::VisualLocalization& localization);

 private:
  void OnSemanticImage(const semantic_slam::SemanticImageConstPtr& msg);
  void Hand(const semantic_slam::SemanticImageConstPtr& msg,
            semantic_slam::VisualLocalization& localization);

  DropCounter& drops_;
  std::optional<semantic_slam::LabelVocabulary> vocabulary_;  // none: without semantics
  std::vector<semantic_slam::LabelId> left_out_;
  std::mutex mutex_;
  std::vector<semantic_slam::SemanticImageConstPtr> waiting_;  // guarded by mutex_; oldest first
  ros::Subscriber subscriber_;                                 // last: it calls the others
};

}  // namespace semantic_slam_ros
