#pragma once

#include <ostream>

#include <nlohmann/json_fwd.hpp>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/network_evaluation/detection_evaluation.h"

namespace semantic_slam {

constexpr char kBackground[] = "background";

// Shares are 0..1, null where there was nothing to count: boxes, map50, map50_95, at_threshold and
// at_best_f1 (threshold, precision, recall, f1, hits, extras, misses, mean_class_precision,
// mean_class_recall), classes (boxes, ap50, ap50_95, precision, recall, f1 by name), confusion,
// time.
nlohmann::ordered_json ToJson(const DetectionEvaluation& evaluation, const ClassList& classes);

// The same as a table for people, without the confusion matrix.
void PrintTable(const DetectionEvaluation& evaluation, const ClassList& classes, std::ostream& out);

}  // namespace semantic_slam
