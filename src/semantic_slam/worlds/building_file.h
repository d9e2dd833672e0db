#pragma once

#include <vector>

#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/worlds/building.h"
#include "semantic_slam/worlds/material_file.h"
#include "semantic_slam/worlds/world_assembly.h"

namespace semantic_slam {

// Reads `wall_thickness_m`, `rooms` and `openings` of a world file and adds the building with its
// doors and windows. Throws ConfigError naming file, line and key.
Building ReadBuilding(YamlReader& file, const MaterialPalette& palette, WorldAssembly& assembly);

}  // namespace semantic_slam
