#pragma once

#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace semantic_slam {

// Decodes the raw output of a YOLOv5 to v7 head on one grid: a box per cell and anchor, given by
// sigmoids relative to both. Immutable, so safe from any thread.
class AnchorGrid {
 public:
  // `stride_px`: pixels of the network's input per cell.
  AnchorGrid(float stride_px, std::vector<cv::Size2f> anchors_px, int columns)
      : stride_px_(stride_px), anchors_px_(std::move(anchors_px)), columns_(columns) {}

  // Whether a network's output of this shape is such a grid: 1 x A x h x w x columns, or
  // 1 x (A * columns) x h x w.
  bool Fits(const std::vector<int>& shape) const;

  // N x columns, CV_32F: centre x, centre y, width and height [px] of the network's input, and the
  // other columns as they are. Precondition: the output's shape fits.
  cv::Mat Decode(const cv::Mat& output) const;

 private:
  const float stride_px_;
  const std::vector<cv::Size2f> anchors_px_;
  const int columns_;
};

}  // namespace semantic_slam
