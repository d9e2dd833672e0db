#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/ground_truth/map_evaluation.h"
#include "semantic_slam/ground_truth/run_outputs.h"

namespace semantic_slam {

// The world and a run's maps side by side in the world frame, x to the right and y up: the true
// floor plan with the true objects; the estimated one with the mapped objects and the camera's
// path, true (grey) and estimated; the semantic grid's cost with both objects' outlines, the true
// ones dashed. What the run did not make is left empty. CV_8UC3, BGR.
cv::Mat DrawMapComparison(const MapEvaluation& evaluation, const RunOutputs& outputs,
                          const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
