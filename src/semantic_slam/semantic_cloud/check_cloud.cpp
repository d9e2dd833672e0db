#include "semantic_slam/semantic_cloud/check_cloud.h"

#include <string>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

// Confidences may have been rounded by whoever sent them.
constexpr float kRounding = 1e-3f;

// Comparisons are written so that NaN fails them.
void CheckConfidences(const std::array<float, kTopLabels>& confidences) {
  float sum = 0.0f;
  for (const float confidence : confidences) {
    if (!(confidence >= 0.0f && confidence <= 1.0f)) {
      throw InputError("semantic cloud: confidence is " + std::to_string(confidence) +
                       ", expected 0 to 1");
    }
    sum += confidence;
  }
  if (sum > 1.0f + kRounding) {
    throw InputError("semantic cloud: confidences of a point sum up to " + std::to_string(sum) +
                     ", expected at most 1");
  }
}

}  // namespace

void CheckSemanticCloud(const SemanticCloud& cloud, const LabelVocabulary& vocabulary) {
  if (cloud.vocabulary_hash != vocabulary.hash()) {
    throw InputError("semantic cloud: made with another label set, hash " +
                     std::to_string(cloud.vocabulary_hash) + ", expected " +
                     std::to_string(vocabulary.hash()));
  }
  for (const SemanticPoint& point : cloud.points) {
    if (!point.position.allFinite()) throw InputError("semantic cloud: a position is not finite");
    CheckConfidences(point.confidences);
    for (const LabelId label : point.labels) {
      if (vocabulary.Contains(label)) continue;
      throw InputError("semantic cloud: label id " + std::to_string(label) +
                       " is not in the vocabulary");
    }
  }
}

}  // namespace semantic_slam
