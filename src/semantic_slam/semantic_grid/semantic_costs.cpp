#include "semantic_slam/semantic_grid/semantic_costs.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/semantic_grid/semantic_cells.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

SemanticCosts::SemanticCosts(const SemanticCostOptions& options) : options_(Validated(options)) {}

std::uint8_t SemanticCosts::OfOccupancy(std::int8_t percent) const {
  if (percent == OccupancyMap::kUnknown) return SemanticCells::kUnknown;
  return Of(0.01 * percent, SemanticCells::kLethal);
}

double SemanticCosts::OfObject(const MapObject& object, const LabelVocabulary& vocabulary) const {
  if (object.max_height_m + options_.height_margin_m < options_.flight_min_height_m ||
      object.min_height_m - options_.height_margin_m > options_.flight_max_height_m) {
    return 0.0;
  }
  double cost = 0.0, probability = 0.0;
  for (const LabelProbability& label : object.labels) {
    cost += label.probability * vocabulary[label.label].cost;
    probability += label.probability;
  }
  return probability > 0.0 ? cost / probability : vocabulary[kUnknownLabel].cost;
}

std::uint8_t SemanticCosts::Of(double probability, double full_cost) const {
  if (probability >= options_.lethal_probability) {
    return static_cast<std::uint8_t>(std::lround(full_cost));
  }
  if (probability <= options_.free_probability) return SemanticCells::kFree;
  const double share = (probability - options_.free_probability) /
                       (options_.lethal_probability - options_.free_probability);
  const long cost = std::lround(share * full_cost);
  return static_cast<std::uint8_t>(std::min<long>(cost, SemanticCells::kInscribed - 1));
}

std::uint8_t SemanticCosts::Combined(std::uint8_t map_cost, double probability,
                                     double full_cost) const {
  const std::uint8_t cost = Of(probability, full_cost);
  if (map_cost != SemanticCells::kUnknown) return std::max(map_cost, cost);
  const bool is_known = probability >= options_.lethal_probability && cost > SemanticCells::kFree;
  return is_known ? cost : map_cost;
}

std::int8_t ToOccupancyPercent(std::uint8_t cost) {
  if (cost == SemanticCells::kFree) return 0;
  if (cost == SemanticCells::kInscribed) return 99;
  if (cost == SemanticCells::kLethal) return 100;
  if (cost == SemanticCells::kUnknown) return OccupancyMap::kUnknown;
  return static_cast<std::int8_t>(1 + 97 * (cost - 1) / 251);
}

}  // namespace semantic_slam
