#include "semantic_slam/worlds/material_file.h"

#include <algorithm>
#include <vector>

#include "semantic_slam/worlds/texture.h"

namespace semantic_slam {
namespace {

std::array<std::uint8_t, 3> ReadColour(YamlReader& reader, const std::string& key) {
  const auto numbers = reader.Require<std::vector<int>>(key);
  const bool are_colours = std::all_of(numbers.begin(), numbers.end(),
                                       [](int value) { return value >= 0 && value <= 255; });
  if (numbers.size() != 3 || !are_colours) reader.Refuse(key, "three numbers from 0 to 255");
  std::array<std::uint8_t, 3> rgb;
  std::copy(numbers.begin(), numbers.end(), rgb.begin());
  return rgb;
}

void ReadPattern(YamlReader& reader, std::string& pattern) {
  reader.Read("pattern", pattern);
  const std::vector<std::string> known = PatternNames();
  if (std::binary_search(known.begin(), known.end(), pattern)) return;
  std::string names;
  for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
  reader.Refuse("pattern", "one of: " + names);
}

void ReadShare(YamlReader& reader, const std::string& key, float& share) {
  reader.Read(key, share);
  if (!(share >= 0.0f && share <= 1.0f)) reader.Refuse(key, "in [0, 1]");
}

Material ReadMapping(YamlReader reader, const Material& usual) {
  Material material = usual;
  ReadPattern(reader, material.pattern);
  if (reader.Has("rgb")) material.rgb = ReadColour(reader, "rgb");
  reader.Read("seed", material.seed);
  ReadShare(reader, "gloss", material.gloss);
  ReadShare(reader, "brightness", material.brightness);
  reader.Finish();
  return material;
}

}  // namespace

MaterialPalette::MaterialPalette(YamlReader& file) {
  YAML::Node map(YAML::NodeType::Map);
  file.Read("materials", map);
  if (!map.IsMap()) file.Refuse("materials", "a mapping");
  YamlReader group(map, file.path(), "materials");
  for (const auto& entry : map) {
    const auto name = entry.first.as<std::string>();
    named_[name] = ReadMapping(group.Group(name), Material());
  }
  group.Finish();
}

Material MaterialPalette::Read(YamlReader& reader, const std::string& key,
                               const Material& usual) const {
  YAML::Node node;
  reader.Read(key, node);
  if (node.IsNull()) return usual;
  if (node.IsMap()) return ReadMapping(reader.Group(key), usual);
  if (node.IsSequence()) {
    Material coloured = usual;
    coloured.rgb = ReadColour(reader, key);
    return coloured;
  }
  const auto found = named_.find(reader.Require<std::string>(key));
  if (found != named_.end()) return found->second;
  std::string names;
  for (const auto& [name, material] : named_) names += (names.empty() ? "" : ", ") + name;
  reader.Refuse(key, "[r, g, b], a mapping or one of materials: " + names);
}

}  // namespace semantic_slam
