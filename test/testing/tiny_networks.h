#pragma once

#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model.h"

// The networks of test/testing/networks, and the vocabulary that their cards map to.

namespace semantic_slam {

inline std::string TinyNetworkCard(const std::string& name) {
  return SEMANTIC_SLAM_SOURCE_DIR "/test/testing/networks/" + name + ".yaml";
}

inline Model ColourSegmenter() {
  return LoadModel(TinyNetworkCard("colour_segmenter"));
}
inline Model BlockDetector() {
  return LoadModel(TinyNetworkCard("block_detector"));
}

// config/labels.yaml.
inline const LabelVocabulary& Vocabulary() {
  static const LabelVocabulary vocabulary =
      LabelVocabulary::Load(SEMANTIC_SLAM_SOURCE_DIR "/config/labels.yaml");
  return vocabulary;
}

inline LabelId LabelOf(const std::string& name) {
  return Vocabulary().Find(name).value();
}

}  // namespace semantic_slam
