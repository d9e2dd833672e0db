#pragma once

#include <map>
#include <string>

#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/worlds/material.h"

namespace semantic_slam {

// The materials that a world file gives names to, and how it speaks of materials.
class MaterialPalette {
 public:
  // Reads the mapping `materials` of a world file. Throws ConfigError naming file, line and key.
  explicit MaterialPalette(YamlReader& file);

  // The material that `key` says: a name of the palette, [r, g, b] for the usual material in
  // another colour, or a mapping of what differs from the usual one. The usual one if it is absent.
  // Throws ConfigError naming file, line and key.
  Material Read(YamlReader& reader, const std::string& key, const Material& usual) const;

 private:
  std::map<std::string, Material> named_;
};

}  // namespace semantic_slam
