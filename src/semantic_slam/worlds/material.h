#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <Eigen/Core>

namespace semantic_slam {

// What a surface looks like: a pattern that texture.h can paint, and its particulars.
struct Material {
  std::string pattern = "plaster";                 // one of PatternNames()
  std::array<std::uint8_t, 3> rgb{200, 200, 200};  // the main colour; patterns vary it
  std::uint64_t seed = 1;  // other seeds give other pieces of the same stuff
  // Size [m] of the one picture that fills the surface (a poster, a row of books, a screen), from
  // texture coordinates (0, 0) to here. Zero: the pattern repeats for ever.
  Eigen::Vector2f picture_size_m = Eigen::Vector2f::Zero();
  float gloss = 0.0f;       // 0 dull .. 1 polished: strength of the highlight
  float brightness = 0.0f;  // 0 lit by lamps only .. 1 shines by itself: a screen, a lampshade
};

// A material of which the rest does not matter.
Material MakeMaterial(const std::string& pattern, const std::array<std::uint8_t, 3>& rgb,
                      float gloss = 0.0f, float brightness = 0.0f);

bool operator==(const Material& a, const Material& b);

}  // namespace semantic_slam
