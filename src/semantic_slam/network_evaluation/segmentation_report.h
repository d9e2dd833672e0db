#pragma once

#include <ostream>

#include <nlohmann/json_fwd.hpp>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/network_evaluation/segmentation_evaluation.h"

namespace semantic_slam {

// What is predicted of no class that counts.
constexpr char kOtherLabels[] = "other";

// Shares are 0..1, null where there was nothing to count: pixels, pixel_accuracy,
// mean_class_accuracy, mean_iou, frequency_weighted_iou, classes (iou, precision, recall,
// pixel_share by name), confusion, time.
nlohmann::ordered_json ToJson(const SegmentationEvaluation& evaluation, const ClassList& classes);

// The same as a table for people, without the confusion matrix.
void PrintTable(const SegmentationEvaluation& evaluation, const ClassList& classes,
                std::ostream& out);

}  // namespace semantic_slam
