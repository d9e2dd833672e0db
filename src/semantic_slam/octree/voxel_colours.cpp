#include "semantic_slam/octree/voxel_colours.h"

#include <algorithm>
#include <cmath>

#include "semantic_slam/common/error.h"

namespace semantic_slam {
namespace {

// From blue (t = 0) over cyan, green and yellow to red (t = 1).
std::array<std::uint8_t, 3> Rainbow(double t) {
  const double x = 4.0 * std::clamp(t, 0.0, 1.0);
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(255.0 * std::clamp(value, 0.0, 1.0));
  };
  return {channel(x - 2.0), channel(std::min(x, 4.0 - x)), channel(2.0 - x)};
}

}  // namespace

ColourMode ColourModeFromName(const std::string& name) {
  if (name == "class") return ColourMode::kClass;
  if (name == "rgb") return ColourMode::kRgb;
  if (name == "height") return ColourMode::kHeight;
  throw ConfigError("colour_mode = " + name + ", but must be one of: class, rgb, height");
}

std::array<std::uint8_t, 3> VoxelColours::operator()(const SemanticNode& node, double z_m) const {
  if (mode_ == ColourMode::kRgb) return node.rgb();
  if (mode_ == ColourMode::kHeight) return Rainbow((z_m - low_m_) / (high_m_ - low_m_));
  const LabelId label = node.labels().label(0);
  return vocabulary_[vocabulary_.Contains(label) ? label : kUnknownLabel].rgb;
}

}  // namespace semantic_slam
