#include "semantic_slam/detection/anchor_grid.h"

#include <cmath>

namespace semantic_slam {
namespace {

float Sigmoid(float x) {
  return 1.0f / (1.0f + std::exp(-x));
}

}  // namespace

bool AnchorGrid::Fits(const std::vector<int>& shape) const {
  const int anchors = static_cast<int>(anchors_px_.size());
  if (shape.size() == 5) return shape[0] == 1 && shape[1] == anchors && shape[4] == columns_;
  return shape.size() == 4 && shape[0] == 1 && shape[1] == anchors * columns_;
}

cv::Mat AnchorGrid::Decode(const cv::Mat& output) const {
  const int anchors = static_cast<int>(anchors_px_.size());
  const int height = output.size[2], width = output.size[3];
  const std::ptrdiff_t cells = static_cast<std::ptrdiff_t>(height) * width;
  // Where the next cell's value of one column is, and where the same cell's next column.
  const std::ptrdiff_t cell_step = output.dims == 5 ? columns_ : 1;
  const std::ptrdiff_t column_step = output.dims == 5 ? 1 : cells;
  cv::Mat rows(static_cast<int>(anchors * cells), columns_, CV_32F);
  for (int i = 0; i < rows.rows; ++i) {
    const int anchor = static_cast<int>(i / cells), cell = static_cast<int>(i % cells);
    const int x = cell % width, y = cell / width;
    const float* from = output.ptr<float>() + anchor * cells * columns_ + cell * cell_step;
    float* row = rows.ptr<float>(i);
    for (int column = 0; column < columns_; ++column) row[column] = from[column * column_step];
    // YOLOv5 as published: centres reach half a cell beyond their own, sizes up to four anchors.
    row[0] = (2.0f * Sigmoid(row[0]) - 0.5f + static_cast<float>(x)) * stride_px_;
    row[1] = (2.0f * Sigmoid(row[1]) - 0.5f + static_cast<float>(y)) * stride_px_;
    row[2] = std::pow(2.0f * Sigmoid(row[2]), 2.0f) * anchors_px_[anchor].width;
    row[3] = std::pow(2.0f * Sigmoid(row[3]), 2.0f) * anchors_px_[anchor].height;
  }
  return rows;
}

}  // namespace semantic_slam
