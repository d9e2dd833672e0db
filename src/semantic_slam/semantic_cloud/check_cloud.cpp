#include "semantic_slam/semantic_cloud/check_cloud.h"

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"

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
  CheckLabelSet("semantic cloud", cloud.vocabulary_hash, vocabulary);
  for (const SemanticPoint& point : cloud.points) {
    if (!point.position.allFinite()) throw InputError("semantic cloud: a position is not finite");
    CheckConfidences(point.confidences);
    for (const LabelId label : point.labels) CheckLabel("semantic cloud", label, vocabulary);
  }
}

}  // namespace semantic_slam
