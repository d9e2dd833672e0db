#pragma once

#include "semantic_slam/worlds/furniture_builder.h"

namespace semantic_slam {

// Mattress, duvet and its folded edge, between the ends `head_m` and `foot_m` (x), as wide as
// `width_m`, from `low_m` up to the bed's number "mattress_top_m" and the duvet above it. The duvet
// hangs over both sides by 2 cm.
void AddBedding(FurnitureBuilder& b, float head_m, float foot_m, float width_m, float low_m);

}  // namespace semantic_slam
