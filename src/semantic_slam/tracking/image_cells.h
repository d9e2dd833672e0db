#pragma once

#include <algorithm>
#include <array>

#include <Eigen/Core>

#include "semantic_slam/camera/camera_model.h"

namespace semantic_slam {

// One T for each of 8 x 6 parts of the undistorted image, T() at first.
template <typename T>
class ImageCells {
 public:
  explicit ImageCells(const CameraModel& camera) : bounds_(camera.undistorted_bounds()) {}

  // Of the part in which the undistorted pixel lies, or to which it is nearest.
  T& At(const Eigen::Vector2f& pixel) {
    const int column = Index((pixel.x() - bounds_.x) / bounds_.width, kColumns);
    const int row = Index((pixel.y() - bounds_.y) / bounds_.height, kRows);
    return cells_[static_cast<std::size_t>(row) * kColumns + column];
  }

  auto begin() const { return cells_.begin(); }
  auto end() const { return cells_.end(); }

 private:
  static constexpr int kColumns = 8, kRows = 6;

  static int Index(float share, int count) {
    return std::clamp(static_cast<int>(share * static_cast<float>(count)), 0, count - 1);
  }

  const cv::Rect2f bounds_;
  std::array<T, kColumns * kRows> cells_{};
};

}  // namespace semantic_slam
