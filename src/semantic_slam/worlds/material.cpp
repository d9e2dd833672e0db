#include "semantic_slam/worlds/material.h"

namespace semantic_slam {

bool operator==(const Material& a, const Material& b) {
  return a.pattern == b.pattern && a.rgb == b.rgb && a.seed == b.seed &&
         a.picture_size_m == b.picture_size_m && a.gloss == b.gloss && a.brightness == b.brightness;
}

}  // namespace semantic_slam
