#include "semantic_slam/random_worlds/random_material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "semantic_slam/random_worlds/choice.h"

namespace semantic_slam {
namespace {

constexpr double kWild = 0.06;          // how often a colour is any at all
constexpr double kWildTraining = 0.15;  // in training, where a pattern may be
constexpr double kStrange = 0.2;        // one that belongs elsewhere
constexpr double kShiny = 0.25;         // how often a surface has a gloss of its own

struct Range {
  double low = 0.0;
  double high = 1.0;
};

// Colours alike: hue [degrees], saturation and value as in HSV.
struct Palette {
  double weight = 1.0;
  Range hue_deg;
  Range saturation;
  Range value;
};

constexpr Range kAnyHue{0, 360};

const Palette& AnyColour() {
  static const Palette any{1, kAnyHue, {0, 0.9}, {0.08, 0.97}};
  return any;
}

// By pattern, or the building's surface where a pattern has another palette there.
const std::map<std::string, std::vector<Palette>>& Palettes() {
  static const Palette white{5, {25, 70}, {0, 0.12}, {0.8, 0.97}};
  static const Palette grey{1, kAnyHue, {0, 0.06}, {0.25, 0.8}};
  static const Palette pastel{3, kAnyHue, {0.1, 0.32}, {0.68, 0.93}};
  static const Palette strong{1.5, kAnyHue, {0.35, 0.75}, {0.3, 0.8}};
  static const Palette dark{1, kAnyHue, {0, 0.3}, {0.08, 0.25}};
  static const Palette brown{6, {18, 38}, {0.25, 0.68}, {0.25, 0.85}};
  static const Palette brick{5, {6, 28}, {0.3, 0.6}, {0.45, 0.78}};
  static const Palette stone{4, {25, 60}, {0.02, 0.25}, {0.35, 0.9}};
  static const Palette black{2, kAnyHue, {0, 0.15}, {0.1, 0.25}};
  static const Palette steel{4, {0, 360}, {0, 0.08}, {0.3, 0.88}};
  static const Palette brass{1, {36, 46}, {0.35, 0.6}, {0.45, 0.75}};
  static const Palette leaf{5, {75, 145}, {0.3, 0.7}, {0.3, 0.62}};
  static const std::map<std::string, std::vector<Palette>> palettes{
      {"wall/plaster", {white, pastel, strong, grey}},
      {"wall/wallpaper", {white, pastel, strong}},
      {"wall/tiles", {white, pastel, grey}},
      {"ceiling/plaster", {{9, {25, 70}, {0, 0.06}, {0.85, 0.98}}, pastel}},
      {"ceiling/ceiling_tiles", {{5, {25, 70}, {0, 0.05}, {0.8, 0.95}}, grey}},
      {"floor/carpet", {grey, {3, kAnyHue, {0.05, 0.45}, {0.2, 0.7}}, stone}},
      {"wall", {white, pastel, strong}},
      {"ceiling", {white, pastel}},
      {"floor", {stone, grey}},
      {"herringbone", {brown, grey}},
      {"panelling", {white, brown, grey}},
      {"brick", {brick, grey, white}},
      {"parquet", {brown, grey}},
      {"wood", {brown, white, grey, strong, dark}},
      {"tiles", {stone, white, grey, brick}},
      {"marble", {stone, white, grey, dark}},
      {"fabric", {{3, kAnyHue, {0, 0.12}, {0.2, 0.85}}, strong, pastel, stone, dark}},
      {"leather", {{3, {12, 35}, {0.3, 0.7}, {0.2, 0.6}}, black, white, strong}},
      {"cloth", {white, pastel, strong, grey, dark}},
      {"carpet", {strong, stone, grey, pastel}},
      {"rug", {strong, stone, pastel}},
      {"curtain", {white, pastel, strong, stone}},
      {"metal", {steel, brass, black}},
      {"plastic", {white, grey, black, strong}},
      {"paper", {white, pastel}},
      {"foliage", {leaf, {1, {30, 75}, {0.3, 0.6}, {0.35, 0.7}}}},
      {"window_view", {{1, {190, 230}, {0.1, 0.5}, {0.55, 0.98}}}},
      {"books", {AnyColour()}},
      {"screen", {AnyColour()}},
      {"painting", {AnyColour()}},
      {"poster", {AnyColour()}},
      {"magazine", {white, pastel, strong}},
      {"cork", {{1, {25, 40}, {0.3, 0.55}, {0.5, 0.8}}}},
      {"cardboard", {{1, {25, 38}, {0.25, 0.5}, {0.5, 0.8}}}},
  };
  return palettes;
}

// HSV to RGB (Smith 1978).
std::array<std::uint8_t, 3> Colour(double hue_deg, double saturation, double value) {
  std::array<std::uint8_t, 3> rgb;
  const double offsets[] = {5, 3, 1};
  for (int i = 0; i < 3; ++i) {
    const double k = std::fmod(offsets[i] + hue_deg / 60.0, 6.0);
    const double share = std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    rgb[i] = static_cast<std::uint8_t>(std::lround(255.0 * value * (1.0 - saturation * share)));
  }
  return rgb;
}

std::array<std::uint8_t, 3> ColourOf(const Palette& palette, RandomStream& random) {
  const double hue_deg = Between(random, palette.hue_deg.low, palette.hue_deg.high);
  const double saturation = Between(random, palette.saturation.low, palette.saturation.high);
  return Colour(hue_deg, saturation, Between(random, palette.value.low, palette.value.high));
}

// What has no palette, as skin, is a little lighter or darker than usual.
std::array<std::uint8_t, 3> Shaded(const std::array<std::uint8_t, 3>& rgb, RandomStream& random) {
  const double factor = Between(random, 0.55, 1.15);
  std::array<std::uint8_t, 3> shaded;
  for (int i = 0; i < 3; ++i) {
    shaded[i] = static_cast<std::uint8_t>(std::min(255.0, factor * rgb[i]));
  }
  return shaded;
}

// nullptr if there are none.
const std::vector<Palette>* FindPalettes(const std::string& name) {
  const auto found = Palettes().find(name);
  return found == Palettes().end() ? nullptr : &found->second;
}

// Of a pattern, else of what stands there usually.
const std::vector<Palette>* PalettesFor(const std::string& pattern, const std::string& usual) {
  const std::vector<Palette>* palettes = FindPalettes(pattern);
  return palettes != nullptr ? palettes : FindPalettes(usual);
}

void Recolour(WorldSplit split, const std::vector<Palette>* palettes, Material& material,
              RandomStream& random) {
  const bool is_wild = Chance(random, split == WorldSplit::kTraining ? kWildTraining : kWild);
  if (palettes == nullptr) {
    material.rgb = Shaded(material.rgb, random);
  } else {
    material.rgb = ColourOf(is_wild ? AnyColour() : WeightedOneOf(random, *palettes), random);
  }
}

void Vary(WorldSplit split, Material& material, RandomStream& random) {
  material.seed = SeedFor(split, random);
  if (Chance(random, kShiny)) {
    material.gloss = static_cast<float>(Between(random, 0.0, 0.6));
  }
}

std::string PatternInPlaceOf(WorldSplit split, const std::string& usual, RandomStream& random) {
  const std::vector<PatternChoice>& choices = PatternsFor(split, usual);
  if (split == WorldSplit::kTraining && !choices.empty() && usual != "painting" &&
      Chance(random, kStrange)) {
    return OneOf(random, TrainingPatterns());
  }
  return choices.empty() ? usual : WeightedOneOf(random, choices).pattern;
}

}  // namespace

Material RandomMaterial(WorldSplit split, const Material& usual, RandomStream& random) {
  Material material = usual;
  material.pattern = PatternInPlaceOf(split, usual.pattern, random);
  if (usual.brightness == 0.0f || usual.pattern != "plastic") {  // milk glass of lamps stays white
    Recolour(split, PalettesFor(material.pattern, usual.pattern), material, random);
  }
  if (usual.brightness > 0.0f && usual.pattern == "fabric") {  // lampshades are light
    for (std::uint8_t& channel : material.rgb) channel = std::max<std::uint8_t>(channel, 150);
  }
  Vary(split, material, random);
  return material;
}

Material RandomSurface(WorldSplit split, const std::string& surface, RandomStream& random) {
  Material material = MakeMaterial(PatternInPlaceOf(split, surface, random), {200, 200, 200});
  const std::vector<Palette>* palettes = FindPalettes(surface + "/" + material.pattern);
  if (palettes == nullptr) palettes = PalettesFor(material.pattern, surface);
  Recolour(split, palettes, material, random);
  Vary(split, material, random);
  if (surface != "floor") material.gloss *= 0.3f;
  return material;
}

}  // namespace semantic_slam
