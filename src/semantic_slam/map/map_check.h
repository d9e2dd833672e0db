#pragma once

#include "semantic_slam/map/map_contents.h"

namespace semantic_slam {

// Throws InputError saying what is wrong if a map cannot be like this: ids that are missing or out
// of order, links that lead nowhere or in a circle, poses that are none, numbers that are not
// finite. Features are not looked at.
void CheckMapContents(const MapContents& contents);

}  // namespace semantic_slam
