#pragma once

#include "semantic_slam/worlds/furniture_builder.h"

namespace semantic_slam {

// A shade that is open below and above: a thin wall between two cones.
Mesh ShadeMesh(const Eigen::Vector3f& foot_m, float bottom_radius_m, float top_radius_m,
               float height_m);

// The light of a lamp on the ceiling, as strong as its number "light" says: a square just below it.
void AddLightBelow(FurnitureBuilder& b, float side_m);

}  // namespace semantic_slam
