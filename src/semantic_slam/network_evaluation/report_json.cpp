#include "semantic_slam/network_evaluation/report_json.h"

#include <cmath>
#include <utility>

namespace semantic_slam {

using Json = nlohmann::ordered_json;

Json NumberOrNull(double value) {
  return std::isnan(value) ? Json(nullptr) : Json(value);
}

Json ToJson(const ConfusionMatrix& matrix, std::vector<std::string> names,
            const std::string& none_name) {
  names.push_back(none_name);
  Json rows = Json::array();
  for (int truth = 0; truth <= matrix.none(); ++truth) {
    Json row = Json::array();
    for (int predicted = 0; predicted <= matrix.none(); ++predicted) {
      row.push_back(matrix.count(truth, predicted));
    }
    rows.push_back(std::move(row));
  }
  return {{"names", std::move(names)}, {"counts", std::move(rows)}};
}

Json ToJson(const StageTiming& timing) {
  return {{"images", timing.count}, {"median_ms", timing.median_ms}, {"p95_ms", timing.p95_ms}};
}

}  // namespace semantic_slam
