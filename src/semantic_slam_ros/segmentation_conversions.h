#pragma once

#include <string>

#include <semantic_slam/LabelSet.h>
#include <semantic_slam/SemanticImage.h>
#include <sensor_msgs/PointCloud2.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

// The 3D branch's types as messages, and back. What reads a message throws
// semantic_slam::InputError with one line that names the fault if it is malformed or speaks of
// other labels than `vocabulary`.

namespace semantic_slam_ros {

// Stamped with `loaded`.
semantic_slam::LabelSet ToLabelSet(const semantic_slam::LabelVocabulary& vocabulary,
                                   semantic_slam::Stamp loaded);

// Precondition: the segmentation passes CheckSegmentation().
semantic_slam::SemanticImagePtr ToSemanticImage(const semantic_slam::Segmentation& segmentation,
                                                const std::string& frame_id);
// Without a copy: the planes are the message's memory, and keep it alive.
semantic_slam::Segmentation ToSegmentation(const semantic_slam::SemanticImageConstPtr& msg,
                                           const semantic_slam::LabelVocabulary& vocabulary);

// One row of points of 32 bytes, with the fields of docs/ros_api.md.
sensor_msgs::PointCloud2Ptr ToPointCloud2(const semantic_slam::SemanticCloud& cloud,
                                          const std::string& frame_id);
// Reads the same fields wherever they lie. Points that are not finite are skipped.
semantic_slam::SemanticCloud ToSemanticCloud(const sensor_msgs::PointCloud2& msg,
                                             const semantic_slam::LabelVocabulary& vocabulary);

}  // namespace semantic_slam_ros
