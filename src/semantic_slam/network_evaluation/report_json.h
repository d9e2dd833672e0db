#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/network_evaluation/confusion_matrix.h"

namespace semantic_slam {

// Null for NaN, which JSON does not have.
nlohmann::ordered_json NumberOrNull(double value);

// names, with `none_name` last, and counts row by row: true, then predicted class.
nlohmann::ordered_json ToJson(const ConfusionMatrix& matrix, std::vector<std::string> names,
                              const std::string& none_name);

// images, median_ms, p95_ms.
nlohmann::ordered_json ToJson(const StageTiming& timing);

}  // namespace semantic_slam
