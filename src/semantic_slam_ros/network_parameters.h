#pragma once

#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model.h"

// What the nodes that run a network share.

namespace semantic_slam_ros {

struct ModelOptions {
  std::string card;    // model card of the network, docs/models.md; must be given
  std::string models;  // folder where its files are looked for first; empty: the usual places only

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("card", self.card);
    visit("models", self.models);
  }
};

// Throws ConfigError naming the parameter if no card is given, or the card, its key or the file
// that is wrong or missing.
semantic_slam::Model LoadModel(const ros::NodeHandle& private_nh, const ModelOptions& options);

// Publishes the vocabulary once, latched, for as long as the result lives.
ros::Publisher PublishLabels(ros::NodeHandle nh, const semantic_slam::LabelVocabulary& vocabulary);

}  // namespace semantic_slam_ros
