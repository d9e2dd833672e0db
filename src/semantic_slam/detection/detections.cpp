#include "semantic_slam/detection/detections.h"

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"
#include "semantic_slam/detection/box_geometry.h"

namespace semantic_slam {
void CheckDetections(const Detections& detections, const LabelVocabulary& vocabulary) {
  CheckLabelSet("detections", detections.vocabulary_hash, vocabulary);
  for (const DetectedBox& found : detections.boxes) {
    CheckLabel("detections", found.label, vocabulary);
    if (!(found.confidence >= 0.0f && found.confidence <= 1.0f)) {
      throw InputError("detections: confidence is " + std::to_string(found.confidence) +
                       ", expected 0 to 1");
    }
    if (!IsUsable(found.box)) {
      throw InputError("detections: a box is empty or not finite");
    }
  }
}

}  // namespace semantic_slam
