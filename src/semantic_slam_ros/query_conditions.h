#pragma once

#include <optional>
#include <string>

#include <geometry_msgs/Point.h>
#include <Eigen/Geometry>

#include "semantic_slam/common/label_vocabulary.h"

// The conditions that the services ask maps with. All throw semantic_slam::InputError with one line
// that names the fault.

namespace semantic_slam_ros {

// nullopt for two equal corners, which mean: anywhere. Refuses corners that are not the lower and
// the upper one.
std::optional<Eigen::AlignedBox3d> ToBox(const geometry_msgs::Point& low,
                                         const geometry_msgs::Point& high);

// nullopt for an empty name, which means: any class. Refuses a name that is in no vocabulary.
std::optional<semantic_slam::LabelId> ToLabel(const std::string& name,
                                              const semantic_slam::LabelVocabulary& vocabulary);

}  // namespace semantic_slam_ros
