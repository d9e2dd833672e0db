#include "semantic_slam/worlds/material.h"

namespace semantic_slam {

Material MakeMaterial(const std::string& pattern, const std::array<std::uint8_t, 3>& rgb,
                      float gloss, float brightness) {
  Material material;
  material.pattern = pattern;
  material.rgb = rgb;
  material.gloss = gloss;
  material.brightness = brightness;
  return material;
}

bool operator==(const Material& a, const Material& b) {
  return a.pattern == b.pattern && a.rgb == b.rgb && a.seed == b.seed &&
         a.picture_size_m == b.picture_size_m && a.gloss == b.gloss && a.brightness == b.brightness;
}

}  // namespace semantic_slam
