#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

enum class Material { kWallpaper, kParquet, kCeiling, kWood, kPackaging };

// The picture on one rectangular surface, rich in corners at every scale, with smaller copies of
// itself for looking at it from afar. Immutable, so safe from any thread.
class ProceduralTexture {
 public:
  // The surface is width_m x height_m with one texel per texel_m; the same seed gives the same
  // picture.
  ProceduralTexture(Material material, double width_m, double height_m, double texel_m,
                    std::uint64_t seed);

  // Colour (BGR, 0..255) at a point of the surface [m], averaged over about `footprint_m`: what one
  // pixel of a camera sees.
  cv::Vec3f Sample(float x_m, float y_m, float footprint_m) const;

  const cv::Mat& image() const { return levels_.front(); }

 private:
  static cv::Vec3f Bilinear(const cv::Mat& image, float x_px, float y_px);

  const float texel_m_;
  std::vector<cv::Mat> levels_;  // CV_8UC3, each half the size of the one before
};

}  // namespace semantic_slam
