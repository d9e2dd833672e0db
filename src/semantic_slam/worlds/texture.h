#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/worlds/material.h"

namespace semantic_slam {

// The names that Material::pattern may have, sorted.
std::vector<std::string> PatternNames();

// The painted picture of a material with smaller copies of itself for looking at it from afar.
// Immutable, so safe from any thread.
class Texture {
 public:
  // The same material gives the same picture. Throws ConfigError naming a pattern that does not
  // exist.
  explicit Texture(const Material& material);

  // Colour (BGR, 0..255) at a place of the surface [m], averaged over about `footprint_m`: what one
  // pixel of a camera sees. Trilinear.
  cv::Vec3f Sample(float x_m, float y_m, float footprint_m) const;

  // The finest picture, CV_8UC3; `texel_m()` metres per pixel.
  const cv::Mat& image() const { return levels_.front(); }
  float texel_m() const { return texel_m_; }

 private:
  float texel_m_ = 0.002f;
  bool repeats_ = true;
  std::vector<cv::Mat> levels_;  // each half the size of the one before
};

}  // namespace semantic_slam
