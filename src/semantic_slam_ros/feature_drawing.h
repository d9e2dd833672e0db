#pragma once

#include <vector>

#include "semantic_slam/common/keyframe_graph.h"
#include "semantic_slam/localization/visual_localization.h"
#include "semantic_slam_ros/conversions.h"

namespace semantic_slam_ros {

// A copy of `colour` for people to look at: features that support the pose as green squares, those on
// what moves as orange crosses, the others as grey dots, and a line below that says how tracking
// goes.
ColourImage DrawFeatures(const ColourImage& colour,
                         const std::vector<semantic_slam::FeatureView>& features,
                         const semantic_slam::TrackedImage& image);

}  // namespace semantic_slam_ros
