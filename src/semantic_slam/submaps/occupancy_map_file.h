#pragma once

#include <string>

#include "semantic_slam/submaps/occupancy_map.h"

namespace semantic_slam {

// Writes `folder`/`name`.pgm and `name`.yaml, as map_saver does and map_server reads: cells of 65 %
// and more are occupied, of less than 25 % free, all others unknown. Throws InputError if the map
// has no cells or a file cannot be written.
void WriteOccupancyMap(const std::string& folder, const OccupancyMap& map,
                       const std::string& name = "grid");

// Reads such a pair of files by the name of the .yaml, as map_server does: in mode "trinary", the
// default, cells become 0, 100 or unknown, in mode "raw" what the picture holds. Stamp, map_id and
// revision are none of the file's. Throws InputError naming the file that is missing or not
// understood.
OccupancyMap ReadOccupancyMap(const std::string& yaml_path);

}  // namespace semantic_slam
