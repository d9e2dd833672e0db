#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/object_mapping/map_object.h"
#include "semantic_slam/semantic_grid/semantic_cells.h"
#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

// The grid for people, thesis Fig. 3.8: x to the right, y up, cropped to what is known. The floor
// plan is grey, from white for free to black for occupied; over it lie the classes' colours, the
// stronger the more probable, the outlines and names of the objects, a legend of the classes and a
// scale. An empty grid gives a picture that says so. CV_8UC3, BGR. `cells` were built of `map` and
// `objects` with `vocabulary`.
cv::Mat DrawSemanticGrid(const SemanticCells& cells, const OccupancyMap& map,
                         const ObjectMap& objects, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
