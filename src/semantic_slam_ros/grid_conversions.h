#pragma once

#include <string>

#include <nav_msgs/OccupancyGrid.h>
#include <semantic_slam/SemanticGrid.h>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/semantic_grid/semantic_cells.h"
#include "semantic_slam/submaps/occupancy_map.h"

// Grid maps as messages, and back. What reads a message throws semantic_slam::InputError with one
// line that names the fault if it is malformed. Grids are upright: a turned origin is refused.

namespace semantic_slam_ros {

nav_msgs::OccupancyGrid ToOccupancyGrid(const semantic_slam::OccupancyMap& map,
                                        const std::string& map_frame);
// map_id and revision, which the message does not carry, are 0. A map without cells will do.
semantic_slam::OccupancyMap ToOccupancyMap(const nav_msgs::OccupancyGrid& msg);

semantic_slam::SemanticGrid ToSemanticGrid(const semantic_slam::SemanticCells& cells,
                                           const std::string& map_frame);
// Refuses also another label set than the vocabulary's, and labels that are not in it.
semantic_slam::SemanticCells ToSemanticCells(const semantic_slam::SemanticGrid& msg,
                                             const semantic_slam::LabelVocabulary& vocabulary);

// The cost alone, for planners and viewers that know no SemanticGrid; see ToOccupancyPercent().
nav_msgs::OccupancyGrid ToOccupancyGrid(const semantic_slam::SemanticCells& cells,
                                        const std::string& map_frame);

}  // namespace semantic_slam_ros
