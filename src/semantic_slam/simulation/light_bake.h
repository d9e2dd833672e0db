#pragma once

#include <vector>

#include "semantic_slam/simulation/lamps.h"
#include "semantic_slam/simulation/light_gather.h"
#include "semantic_slam/simulation/still_scene.h"

namespace semantic_slam {

// Finds out the light on everything in `scene`: of the lamps, with soft shadows; what surfaces
// throw on each other, once; and light from everywhere, less in corners. `ambient` and
// `reflectances` are as in LightGatherer. Takes some seconds for a house, on all cores; the same on
// any number of them.
void BakeLight(const std::vector<Lamp>& lamps, const Eigen::Vector3f& ambient,
               const std::vector<Reflectance>& reflectances, StillScene& scene);

}  // namespace semantic_slam
