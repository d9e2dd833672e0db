#pragma once

#include <ostream>

#include <nlohmann/json_fwd.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/ground_truth/map_evaluation.h"

namespace semantic_slam {

// Keys end in their unit, shares are 0..1: trajectory (ate_rmse_m, ...), voxels (right, strict,
// without_surface, by_class, by_observations), objects (expected, found, missed, extra,
// right_class, position_mean_m, ...), grid, semantic_grid (free_precision, ...), hollow_area. What
// there is not is null.
nlohmann::ordered_json ToJson(const MapEvaluation& evaluation, const LabelVocabulary& vocabulary);

// The same as a table for people: a line per quantity, "-" for what there is not.
void PrintTable(const MapEvaluation& evaluation, const LabelVocabulary& vocabulary,
                std::ostream& out);

}  // namespace semantic_slam
