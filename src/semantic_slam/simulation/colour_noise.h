#pragma once

#include <array>

#include <opencv2/core.hpp>

#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// In steps of the pixel values 0..255.
struct ColourNoiseOptions {
  bool noise = true;        // false: exact
  double read_sigma = 1.0;  // standard deviation in the dark
  double shot_sigma = 2.0;  // what light adds to it, as the root of a sum of squares, at 255;
                            // grows with the root of the value
  double vignetting = 0.1;  // share of the value that the corners of the image lose
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("noise", self.noise);
    visit("read_sigma", self.read_sigma, 0.0, 100.0);
    visit("shot_sigma", self.shot_sigma, 0.0, 100.0);
    visit("vignetting", self.vignetting, 0.0, 1.0);
    visit("seed", self.seed, 0, 1000000);
  }
};

// Makes of an exact colour image what a small camera would deliver. Immutable, so safe from any
// thread.
class ColourNoise {
 public:
  // Throws ConfigError if an option is out of range.
  explicit ColourNoise(const ColourNoiseOptions& options);

  // The same seed, image and stamp give the same bytes on any number of cores. Precondition:
  // `colour` is CV_8UC3.
  cv::Mat Apply(const cv::Mat& colour, Stamp stamp) const;

 private:
  const ColourNoiseOptions options_;
  std::array<float, 256> sigma_{};  // by pixel value
};

}  // namespace semantic_slam
