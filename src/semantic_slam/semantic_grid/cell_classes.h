#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/semantic_grid/presence_patch.h"
#include "semantic_slam/semantic_grid/semantic_cells.h"

namespace semantic_slam {

// An object and the cells that it may cover; `patch.cells` count from the grid's cell (0, 0) and
// lie inside the grid.
struct PlacedObject {
  const MapObject* object;
  PresencePatch patch;
};

// Fills in which classes the cells hold. A cell is a column, in which things stand on each other,
// so each class has a probability of its own: that at least one of the objects covers the cell and
// is of that class, which are independent of each other,
//
//   P(class in cell) = 1 - prod over objects (1 - P(object covers cell) P(object is of class)).
//
// Two views of one thing as the same class strengthen each other, a monitor on a desk leaves the
// desk as probable as it was, and the probabilities of a cell may sum up to more than 1. The most
// probable cells.classes_per_cell are kept, those under `min_probability` are not.
void FillClasses(const std::vector<PlacedObject>& objects, const LabelVocabulary& vocabulary,
                 double min_probability, SemanticCells& cells);

}  // namespace semantic_slam
