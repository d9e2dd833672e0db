#include "semantic_slam_ros/network_parameters.h"

#include "semantic_slam/common/error.h"
#include "semantic_slam_ros/conversions.h"
#include "semantic_slam_ros/segmentation_conversions.h"
#include "semantic_slam_ros/topics.h"

namespace semantic_slam_ros {

semantic_slam::Model LoadModel(const ros::NodeHandle& private_nh, const ModelOptions& options) {
  if (options.card.empty()) {
    throw semantic_slam::ConfigError(private_nh.resolveName("card") +
                                     " is empty, but must name a model card: one of config/cards "
                                     "of this package, or your own (docs/models.md)");
  }
  return semantic_slam::LoadModel(options.card, options.models);
}

ros::Publisher PublishLabels(ros::NodeHandle nh, const semantic_slam::LabelVocabulary& vocabulary) {
  ros::Publisher publisher = nh.advertise<semantic_slam::LabelSet>(topics::kLabels, 1, true);
  publisher.publish(ToLabelSet(vocabulary, ToStamp(ros::Time::now())));
  return publisher;
}

}  // namespace semantic_slam_ros
