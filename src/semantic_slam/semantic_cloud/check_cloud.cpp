#include "semantic_slam/semantic_cloud/check_cloud.h"

#include <string>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

// Confidences may have been rounded by whoever sent them.
constexpr float kRounding = 1e-3f;

// Comparisons are written so that NaN fails them.
bool AreProbabilities(const std::array<float, kTopLabels>& confidences) {
  float sum = 0.0f;
  for (const float confidence : confidences) {
    if (!(confidence >= 0.0f && confidence <= 1.0f)) return false;
    sum += confidence;
  }
  return sum <= 1.0f + kRounding;
}

[[noreturn]] void Refuse(std::size_t index, const std::string& why) {
  throw InputError("semantic cloud: point " + std::to_string(index) + " " + why);
}

}  // namespace

void CheckSemanticCloud(const SemanticCloud& cloud, const LabelVocabulary& vocabulary) {
  if (cloud.vocabulary_hash != vocabulary.hash()) {
    throw InputError("semantic cloud: made with another label set, hash " +
                     std::to_string(cloud.vocabulary_hash) + ", expected " +
                     std::to_string(vocabulary.hash()));
  }
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const SemanticPoint& point = cloud.points[i];
    if (!point.position.allFinite()) Refuse(i, "has a position that is not finite");
    if (!AreProbabilities(point.confidences)) {
      Refuse(i,
             "has confidences that are no probabilities, expected 0 to 1 with a sum of at most 1");
    }
    for (const LabelId label : point.labels) {
      if (!vocabulary.Contains(label)) {
        Refuse(i, "has label id " + std::to_string(label) + ", which is not in the vocabulary");
      }
    }
  }
}

}  // namespace semantic_slam
