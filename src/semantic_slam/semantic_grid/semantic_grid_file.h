#pragma once

#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/semantic_grid/semantic_cells.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

// Writes into `folder`
//   semantic_grid.png   what DrawSemanticGrid() draws,
//   semantic_grid.pgm, semantic_grid.yaml
//                       the cost, for map_server: mode raw, a pixel is ToOccupancyPercent() of its
//                       cell, 255 for unknown.
// `cells` were built of `map` and `objects`. Throws InputError if the grid has no cells or a file
// cannot be written.
void WriteSemanticGrid(const std::string& folder, const SemanticCells& cells,
                       const OccupancyMap& map, const ObjectMap& objects,
                       const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
