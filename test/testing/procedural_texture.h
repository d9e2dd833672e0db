#pragma once

#include <cstdint>

#include "semantic_slam/worlds/texture.h"

namespace semantic_slam {

enum class FaceStuff { kWallpaper, kParquet, kCeiling, kWood, kPackaging };

// The picture on one rectangular face of width_m x height_m with one texel per texel_m, rich in
// corners at every scale; the same seed gives the same picture.
Texture PaintFace(FaceStuff stuff, double width_m, double height_m, double texel_m,
                  std::uint64_t seed);

}  // namespace semantic_slam
