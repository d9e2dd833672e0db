#include "semantic_slam/worlds/world_file.h"

#include <filesystem>
#include <vector>

#include "semantic_slam/common/yaml_options.h"
#include "semantic_slam/worlds/building_file.h"
#include "semantic_slam/worlds/furniture_file.h"
#include "semantic_slam/worlds/material_file.h"
#include "semantic_slam/worlds/world_assembly.h"

namespace semantic_slam {
namespace {

// Red, green, blue of light.
std::array<float, 3> ReadLightColour(YamlReader& reader, const std::string& key,
                                     const std::array<float, 3>& usual) {
  std::vector<float> numbers(usual.begin(), usual.end());
  reader.Read(key, numbers);
  if (numbers.size() != 3) reader.Refuse(key, "[red, green, blue]");
  for (const float number : numbers) {
    if (!(number >= 0.0f && number <= 100.0f)) reader.Refuse(key, "numbers in [0, 100]");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

Light ReadLight(YamlReader& reader) {
  Light light;
  const auto centre_m = reader.Require<std::vector<double>>("centre_m");
  if (centre_m.size() != 3) reader.Refuse("centre_m", "[x, y, z]");
  light.centre_m = {centre_m[0], centre_m[1], centre_m[2]};
  reader.Read("side_m", light.side_m);
  if (!(light.side_m > 0.0 && light.side_m < 100.0)) reader.Refuse("side_m", "positive");
  light.radiant_rgb = ReadLightColour(reader, "radiant_rgb", light.radiant_rgb);
  reader.Finish();
  return light;
}

}  // namespace

World LoadWorld(const std::string& path, const LabelVocabulary& vocabulary) {
  YamlReader file(LoadYamlMap(path), path);
  WorldAssembly assembly(std::filesystem::path(path).stem().string(), vocabulary);
  assembly.SetAmbient(ReadLightColour(file, "ambient_rgb", World().ambient_rgb));
  const MaterialPalette palette(file);
  const Building building = ReadBuilding(file, palette, assembly);
  ReadFurniture(file, palette, building, assembly);
  for (YamlReader& light : file.Entries("lights")) assembly.AddLight(ReadLight(light));
  file.Finish();
  return assembly.Finish();
}

}  // namespace semantic_slam
