#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "semantic_slam/object_mapping/map_object.h"

namespace semantic_slam {

// The objects of which `label` is the most probable class and whose oriented box meets `box_m`
// (touching will do), by ascending id. What is not given may be anything.
std::vector<MapObject> FindObjects(const ObjectMap& map, std::optional<LabelId> label,
                                   const std::optional<Eigen::AlignedBox3d>& box_m);

}  // namespace semantic_slam
