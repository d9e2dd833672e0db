#pragma once

#include <cstdint>
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
  // exist, a picture without a size, or a size of something that repeats for ever.
  explicit Texture(const Material& material);
  // One picture that fills `size_m`, both positive; shares the pixels of `image`, CV_8UC3.
  Texture(const cv::Mat& image, const Eigen::Vector2f& size_m);

  // Colour (BGR, 0..255) at a place of the surface [m], averaged over about `footprint_m`: what one
  // pixel of a camera sees. Trilinear (Williams, Pyramidal Parametrics, SIGGRAPH 1983), blending
  // two sizes linearly in the footprint. Beyond its edges a picture goes on as at the edge. Any
  // number is allowed, even NaN.
  cv::Vec3f Sample(float x_m, float y_m, float footprint_m) const;

  // The finest picture, CV_8UC3; `texel_m()` metres per pixel.
  const cv::Mat& image() const { return levels_.front().image; }
  float texel_m() const { return texel_m_; }

  std::size_t SizeInBytes() const;

 private:
  struct Level {
    cv::Mat image;  // half the size of the one before
    cv::Vec2f texels_per_m;
  };
  void AddSmallerCopies();
  template <bool kRepeats>
  static cv::Vec3f Bilinear(const Level& level, float x_m, float y_m);
  cv::Vec3f SampleLevel(int level, float x_m, float y_m) const {
    return repeats_ ? Bilinear<true>(levels_[level], x_m, y_m)
                    : Bilinear<false>(levels_[level], x_m, y_m);
  }

  float texel_m_;
  bool repeats_;
  std::vector<Level> levels_;
};

}  // namespace semantic_slam
