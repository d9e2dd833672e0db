#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/network_evaluation/detection_score.h"

namespace semantic_slam {

// Draws precision over recall at IoU 0.5, BGR: a curve per class with true boxes, as far as the
// legend has room those of the highest AP, and dark their mean. `names` are the classes'.
cv::Mat DrawPrecisionRecall(const DetectionScore& score, const std::vector<std::string>& names);

}  // namespace semantic_slam
