#pragma once

#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/options.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/semantic_grid/cell_classes.h"
#include "semantic_slam/semantic_grid/semantic_cells.h"
#include "semantic_slam/semantic_grid/semantic_costs.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

struct SemanticGridOptions {
  int classes_per_cell = 3;             // k most probable ones are kept
  double min_class_probability = 0.05;  // less probable classes of a cell are not listed
  double max_position_sigma_m = 0.1;  // of an object: a worse position blurs its footprint no more
  double resolution_m = 0.05;         // of the cells while there is no occupancy map
  double max_side_m = 200.0;          // objects that would make the grid longer are left out

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("classes_per_cell", self.classes_per_cell, 1, 10);
    visit("min_class_probability", self.min_class_probability, 0.0, 1.0);
    visit("max_position_sigma_m", self.max_position_sigma_m, 0.0, 1.0);
    visit("resolution_m", self.resolution_m, 0.01, 1.0);
    visit("max_side_m", self.max_side_m, 1.0, 1000.0);
  }
};

// Makes the probabilistic semantic grid of thesis section 3.4.4 out of the floor plan and the
// object map: for every cell the classes that it may hold, between which heights, and what it
// costs. A table of which the floor plan shows the legs becomes the whole area of its footprint.
// Immutable, so safe from any thread.
class SemanticGridBuilder {
 public:
  // Throws ConfigError if an option is out of range.
  SemanticGridBuilder(const SemanticGridOptions& options, const SemanticCostOptions& cost_options,
                      LabelVocabulary vocabulary);

  const LabelVocabulary& vocabulary() const { return vocabulary_; }

  // The grid in the cells of `map`, grown so that all footprints fit. Either may be empty. map_id
  // and revision are those of the objects, or the map's if there are none. Throws InputError if the
  // objects were made with another label set or the map's cells do not fit its size.
  SemanticCells Build(const OccupancyMap& map, const ObjectMap& objects) const;

 private:
  std::vector<PlacedObject> Place(const OccupancyMap& map, const ObjectMap& objects,
                                  cv::Rect& area) const;
  SemanticCells Unfilled(const OccupancyMap& map, const ObjectMap& objects,
                         const cv::Rect& area) const;
  void AddOccupancy(const OccupancyMap& map, const cv::Rect& area, SemanticCells& cells) const;
  void AddObject(const PlacedObject& placed, SemanticCells& cells) const;

  const SemanticGridOptions options_;
  const SemanticCosts costs_;
  const double height_probability_;  // a cell's heights are those of objects that fill it so surely
  const LabelVocabulary vocabulary_;
};

}  // namespace semantic_slam
