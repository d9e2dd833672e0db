#pragma once

#include <memory>

#include "semantic_octree/mapping_method.h"

namespace semantic_slam {

// Our mapper as octomap_node runs it, its default options but for resolution and ranges:
// the cloud is checked, entered with colour and three labels a voxel, and kept for rebuilding.
std::unique_ptr<MappingMethod> MakeSemanticMethod(const MappingSettings& settings);

}  // namespace semantic_slam
