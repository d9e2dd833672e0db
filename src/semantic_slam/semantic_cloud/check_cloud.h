#pragma once

#include <Eigen/Geometry>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

namespace semantic_slam {

// What a cloud holds.
struct CloudContents {
  LabelMask labels;              // all that any point has, "unknown" too
  Eigen::AlignedBox3f around_m;  // all points and the camera, in the cloud's frame
};

// Throws InputError, naming what is wrong, unless the cloud was made with `vocabulary`, every
// position is finite, every label id is in the vocabulary, and every point's confidences lie in [0,
// 1] and add up to at most 1. Clouds from outside pass through here before they meet a map. Returns
// what it has seen on the way.
CloudContents CheckSemanticCloud(const SemanticCloud& cloud, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
