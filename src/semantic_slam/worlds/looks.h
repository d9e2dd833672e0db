#pragma once

#include <vector>

#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

// What each object of a world looks like, as a number from 1 on, by ascending instance. Objects of
// the same label, shapes and materials, such as the chairs around a table, have the same: no
// picture tells them apart.
std::vector<int> LooksOf(const World& world);

}  // namespace semantic_slam
