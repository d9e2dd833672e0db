#pragma once

#include <optional>
#include <string>

#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/worlds/building.h"
#include "semantic_slam/worlds/furniture.h"
#include "semantic_slam/worlds/material_file.h"
#include "semantic_slam/worlds/world_assembly.h"

namespace semantic_slam {

// Where a piece comes to be.
struct PiecePlace {
  Rigid3d T_world_object = Rigid3d::Identity();
  std::optional<Walk> walk;
  std::string prefix;  // of its name
};

// Reads what the entry says of a piece besides its kind and place (`name`, `seed`, `materials`),
// refuses what else it says, and adds the piece. Throws ConfigError naming file, line and key.
void AddPiece(YamlReader& reader, const std::string& kind, FurnitureRequest request,
              const MaterialPalette& palette, const PiecePlace& place, WorldAssembly& assembly);

// Reads `groups` and `furniture` of a world file and adds all pieces. Throws ConfigError naming
// file, line and key.
void ReadFurniture(YamlReader& file, const MaterialPalette& palette, const Building& building,
                   WorldAssembly& assembly);

}  // namespace semantic_slam
