#pragma once

#include <string>

#include <ros/node_handle.h>

#include "semantic_slam/common/label_vocabulary.h"

namespace semantic_slam_ros {

struct LabelOptions {
  std::string labels;  // file with the label vocabulary, config/labels.yaml; must be given

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("labels", self.labels);
  }
};

// Reads the vocabulary. Throws ConfigError naming the parameter if it is empty, or the file and the
// key that are wrong.
semantic_slam::LabelVocabulary LoadLabels(const ros::NodeHandle& private_nh,
                                          const LabelOptions& options);

}  // namespace semantic_slam_ros
