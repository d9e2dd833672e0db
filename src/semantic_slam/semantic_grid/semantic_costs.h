#pragma once

#include <cstdint>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/object_mapping/map_object.h"

namespace semantic_slam {

struct SemanticCostOptions {
  // What is there with this probability or more costs in full, an occupied cell as well as an
  // object; with free_probability or less it costs nothing; between them in proportion.
  double lethal_probability = 0.65;
  double free_probability = 0.25;
  // What of the map's z the robot takes up while it flies. An object matters if its own heights,
  // with the margin at both ends, meet these.
  double flight_min_height_m = -0.2;
  double flight_max_height_m = 0.2;
  double height_margin_m = 0.1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("lethal_probability", self.lethal_probability, 0.01, 1.0);
    visit("free_probability", self.free_probability, 0.0, self.lethal_probability);
    visit("flight_min_height_m", self.flight_min_height_m, -100.0, self.flight_max_height_m);
    visit("flight_max_height_m", self.flight_max_height_m, -100.0, 100.0);
    visit("height_margin_m", self.height_margin_m, 0.0, 10.0);
  }
};

// What a grid cell costs, in costmap_2d's values: thesis section 3.4.4. Immutable, so safe from any
// thread.
class SemanticCosts {
 public:
  // Throws ConfigError if an option is out of range.
  explicit SemanticCosts(const SemanticCostOptions& options);

  // Of a cell that is occupied with `percent`, 0..100, or OccupancyMap::kUnknown.
  std::uint8_t OfOccupancy(std::int8_t percent) const;

  // Of a cell that the object surely fills, 0..254: the mean of its classes' costs by their
  // probabilities, so that a chair or sofa costs no less for being one or the other. What the
  // object may be besides is taken to cost the same. 0 if the robot passes above or below.
  double OfObject(const MapObject& object, const LabelVocabulary& vocabulary) const;

  // Of a cell that something costing `full_cost` fills with a probability. Never kInscribed, which
  // speaks of the robot's size, unless full_cost is.
  std::uint8_t Of(double probability, double full_cost) const;

  // The greater of the map's cost and an object's. A cell that the map does not know stays unknown
  // unless the object fills it with lethal_probability or more: a slight chance of a chair does not
  // make it passable.
  std::uint8_t Combined(std::uint8_t map_cost, double probability, double full_cost) const;

 private:
  const SemanticCostOptions options_;
};

// A cost as costmap_2d publishes it in an OccupancyGrid: free 0, inscribed 99, lethal 100, unknown
// -1, and what is between on 1..98 in proportion.
std::int8_t ToOccupancyPercent(std::uint8_t cost);

}  // namespace semantic_slam
