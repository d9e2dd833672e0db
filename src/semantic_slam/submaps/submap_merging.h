#pragma once

#include <cstddef>
#include <vector>

#include "semantic_slam/submaps/occupancy_map.h"
#include "semantic_slam/submaps/submap.h"

namespace semantic_slam {

// The floor plan that all submaps draw together: their evidence about each cell of the map is added
// up, by ascending id. Origin and size are such that cells stay where they are from one time to the
// next: cell borders lie at whole multiples of the resolution. Stamp, map_id and revision are left
// to the caller. Precondition: all submaps have that resolution.
OccupancyMap MergeSubmaps(const std::vector<const Submap*>& submaps, double resolution_m);

// Position in `submaps` of the one that would be missed least: which has the fewest cells that no
// other knows; the oldest of them. Precondition: there is one.
std::size_t LeastMissed(const std::vector<const Submap*>& submaps);

}  // namespace semantic_slam
