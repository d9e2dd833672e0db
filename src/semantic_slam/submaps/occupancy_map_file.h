#pragma once

#include <string>

#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

// Writes `folder`/grid.pgm and grid.yaml, as map_saver does and map_server reads: cells of 65 % and
// more are occupied, of less than 25 % free, all others unknown. Throws InputError if the map has
// no cells or a file cannot be written.
void WriteOccupancyMap(const std::string& folder, const OccupancyMap& map);

}  // namespace semantic_slam
