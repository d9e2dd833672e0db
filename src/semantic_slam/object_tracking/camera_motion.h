#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/object_tracking/box_filter.h"

namespace semantic_slam {

struct CameraMotionOptions {
  int max_corners = 1000;        // followed from one image to the next
  double corner_quality = 0.01;  // of the best corner's, that a corner needs
  double min_distance_px = 1.0;  // between two corners, at half size
  int block_size_px = 3;         // of corner detection
  int min_inliers = 10;          // corners that must agree on the motion

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("max_corners", self.max_corners, 10, 10000);
    visit("corner_quality", self.corner_quality, 1e-4, 1.0);
    visit("min_distance_px", self.min_distance_px, 0.0, 100.0);
    visit("block_size_px", self.block_size_px, 2, 31);
    visit("min_inliers", self.min_inliers, 4, 10000);
  }
};

// How the background moves from image to image when the camera does: corners of the last image,
// followed by pyramidal Lucas-Kanade flow at half size, and the shift, turn and zoom that most of
// them agree on (BoT-SORT, section 3.2). Not thread-safe.
class CameraMotion {
 public:
  // Throws ConfigError if an option is out of range.
  explicit CameraMotion(const CameraMotionOptions& options = {});

  // From the image before to this one, in pixels of the full image. Identity where it cannot be
  // told: for the first image, one of another size, too few corners in common, an absurd zoom.
  // `image` is CV_8UC1 or CV_8UC3, colours in any order; an empty one begins anew.
  ImageMotion Update(const cv::Mat& image);

 private:
  ImageMotion MotionTo(const cv::Mat& half) const;

  const CameraMotionOptions options_;
  cv::Mat last_half_;                      // grey, half size
  std::vector<cv::Point2f> last_corners_;  // of last_half_
};

}  // namespace semantic_slam
