#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace semantic_slam {

// How a camera makes pixels of light: the brighter, the less it takes to be white. Immutable, so
// safe from any thread.
class ToneCurve {
 public:
  ToneCurve();

  // A colour of 0..255, as painted, as the share of light that it throws back.
  static Eigen::Vector3f Linear(const cv::Vec3f& painted) {
    const Eigen::Vector3f share(painted[0], painted[1], painted[2]);
    return (share / 255.0f).cwiseAbs2();
  }

  // 0..255 for light of 0 (black) and up; 1 is white paper in full light.
  cv::Vec3b Pixel(const Eigen::Vector3f& light) const {
    return {Byte(light[0]), Byte(light[1]), Byte(light[2])};
  }

  // The light that makes such a pixel; for 255 the least that may.
  static float LightOf(std::uint8_t pixel);

 private:
  static constexpr int kSteps = 4096;
  static constexpr float kBrightest = 4.0f;  // whiter than white

  std::uint8_t Byte(float light) const;

  std::array<std::uint8_t, kSteps> bytes_;  // by the root of light
};

}  // namespace semantic_slam
