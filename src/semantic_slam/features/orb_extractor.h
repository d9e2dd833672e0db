#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "semantic_slam/common/options.h"
#include "semantic_slam/features/descriptor.h"

namespace semantic_slam {

struct OrbExtractorOptions {
  int max_features = 1200;    // per image, over all pyramid levels
  int pyramid_levels = 8;     // level 0 is the image itself
  double pyramid_scale = 1.2;  // size of a level over that of the next
  int fast_threshold = 20;    // grey levels; FAST's contrast for a corner
  int min_fast_threshold = 7;  // used in those cells where the first finds nothing
  int cell_size_px = 35;      // side of such a cell

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_features", self.max_features, 100, 10000);
    visit("pyramid_levels", self.pyramid_levels, 1, 12);
    visit("pyramid_scale", self.pyramid_scale, 1.05, 2.0);
    visit("fast_threshold", self.fast_threshold, 2, 255);
    visit("min_fast_threshold", self.min_fast_threshold, 2, self.fast_threshold);
    visit("cell_size_px", self.cell_size_px, 16, 200);
  }
};

struct Keypoint {
  Eigen::Vector2f pixel;  // in the image given to Extract()
  float angle_rad;        // of the patch's intensity centroid, in [0, 2 pi); x to y
  float response;         // FAST score, grey levels
  int octave;             // pyramid level
};

struct Keypoints {
  std::vector<Keypoint> keypoints;
  std::vector<Descriptor> descriptors;  // parallel
};

// Scale factor of each pyramid level: 1, s, s^2, ...
std::vector<float> PyramidScales(const OrbExtractorOptions& options);

// ORB features: FAST corners on an image pyramid, spread over the image by a quadtree, turned to
// their intensity centroid and described by 256 tests (Rublee et al., ICCV 2011; the quadtree as in
// Mur-Artal et al., ORB-SLAM, T-RO 2015, section IV.B). Safe from any thread.
class OrbExtractor {
 public:
  // Throws ConfigError if an option is out of range.
  explicit OrbExtractor(const OrbExtractorOptions& options);

  // About max_features keypoints of `grey` (CV_8UC1), at most two more per pyramid level, by
  // ascending octave. Fewer where the image has no texture; empty if it is too small for one patch.
  Keypoints Extract(const cv::Mat& grey) const;

  const std::vector<float>& scales() const { return scales_; }

 private:
  std::vector<cv::KeyPoint> DetectOnLevel(const cv::Mat& level, int wanted) const;

  const OrbExtractorOptions options_;
  const std::vector<float> scales_;
  std::vector<int> features_per_level_;
};

}  // namespace semantic_slam
