#pragma once

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/semantic_cloud/semantic_cloud.h"

namespace semantic_slam {

// Throws InputError, naming what is wrong, unless the cloud was made with `vocabulary`, every
// position is finite, every label id is in the vocabulary, and every point's confidences lie in [0,
// 1] and add up to at most 1. Clouds from outside pass through here before they meet a map.
void CheckSemanticCloud(const SemanticCloud& cloud, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
