#include "semantic_slam_ros/label_parameter.h"

#include "semantic_slam/common/error.h"

namespace semantic_slam_ros {

semantic_slam::LabelVocabulary LoadLabels(const ros::NodeHandle& private_nh,
                                          const LabelOptions& options) {
  if (options.labels.empty()) {
    throw semantic_slam::ConfigError(private_nh.resolveName("labels") +
                                     " is empty, but must name the file with the label vocabulary: "
                                     "config/labels.yaml of this package");
  }
  return semantic_slam::LabelVocabulary::Load(options.labels);
}

}  // namespace semantic_slam_ros
