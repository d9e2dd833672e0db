#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/stamp.h"
#include "semantic_slam/simulation/pixel_noise.h"

namespace semantic_slam {

// Of the stereo cameras in a D455, whose depth at 4 m is good to 2 % by its data sheet.
struct DepthNoiseOptions {
  bool noise = true;                      // false: exact, without limits
  double min_depth_m = 0.4;               // nothing is measured nearer
  double max_depth_m = 6.0;               // nor farther
  double baseline_m = 0.095;              // between the two cameras
  double disparity_sigma_px = 0.08;       // standard deviation of the disparity: depth's is
                                          // depth^2 / (focal length * baseline) times that
  double disparity_step_px = 0.03125;     // disparities are multiples of it
  double edge_step_px = 1.0;              // a greater step of disparity between pixels is an edge
  double edge_dropout_probability = 0.5;  // of a pixel at an edge
  double clear_cosine = 0.25;  // of the angle between ray and normal: with less, some returns fail,
  double blind_cosine = 0.05;  // with less than that, all
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("noise", self.noise);
    visit("min_depth_m", self.min_depth_m, 0.0, 100.0);
    visit("max_depth_m", self.max_depth_m, self.min_depth_m, 1000.0);
    visit("baseline_m", self.baseline_m, 0.001, 10.0);
    visit("disparity_sigma_px", self.disparity_sigma_px, 0.0, 10.0);
    visit("disparity_step_px", self.disparity_step_px, 0.0, 10.0);
    visit("edge_step_px", self.edge_step_px, 0.01, 1000.0);
    visit("edge_dropout_probability", self.edge_dropout_probability, 0.0, 1.0);
    visit("clear_cosine", self.clear_cosine, 0.0, 1.0);
    visit("blind_cosine", self.blind_cosine, 0.0, self.clear_cosine);
    visit("seed", self.seed, 0, 1000000);
  }
};

// Makes of exact depth what a stereo camera would measure: noise and steps that grow with the
// square of depth, and no return out of range, at grazing incidence, at edges, and beside things
// that hide from the second camera what the first one sees. No pixel lies between two surfaces.
// Immutable, so safe from any thread.
class DepthNoise {
 public:
  // `focal_length_px` is the camera's along rows. Throws ConfigError if an option is out of range.
  DepthNoise(const DepthNoiseOptions& options, double focal_length_px);

  // `depth_m` and `incidence` are a RenderedView's; NaN in the result where there is no return. The
  // same seed, image and stamp give the same bytes on any number of cores. Precondition: they are
  // CV_32FC1 and of one size.
  cv::Mat Apply(const cv::Mat& depth_m, const cv::Mat& incidence, Stamp stamp) const;

 private:
  void ApplyToRow(int v, const cv::Mat& disparity_px, const cv::Mat& incidence,
                  const PixelNoise& random, cv::Mat& noisy_m) const;
  bool IsAtEdge(const cv::Mat& disparity_px, int v, int u) const;
  float Measured(float disparity_px, float gaussian) const;

  const DepthNoiseOptions options_;
  const float focal_baseline_;  // [px m]: disparity = that / depth
};

}  // namespace semantic_slam
