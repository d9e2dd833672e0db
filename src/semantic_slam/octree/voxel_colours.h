#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/octree/semantic_octree.h"

namespace semantic_slam {

enum class ColourMode { kClass, kRgb, kHeight };

// Throws ConfigError, listing the names, if `name` is none of "class", "rgb", "height".
ColourMode ColourModeFromName(const std::string& name);

// What colour a voxel is shown in: that of its class, its own, or one for its height. Immutable, so
// safe from any thread; `vocabulary` must outlive it.
class VoxelColours {
 public:
  // Heights run through the rainbow, blue at `low_m`, red at `high_m`.
  VoxelColours(ColourMode mode, const LabelVocabulary& vocabulary, double low_m = 0.0,
               double high_m = 2.0)
      : mode_(mode), vocabulary_(vocabulary), low_m_(low_m), high_m_(high_m) {}

  // Red, green, blue of a voxel at the height `z_m`. A voxel of no known class has the colour of
  // "unknown", in whatever way it lacks one.
  std::array<std::uint8_t, 3> operator()(const SemanticNode& node, double z_m) const;

 private:
  const ColourMode mode_;
  const LabelVocabulary& vocabulary_;
  const double low_m_;
  const double high_m_;
};

}  // namespace semantic_slam
