#pragma once

#include <opencv2/core.hpp>

namespace semantic_slam {

enum class FitMode {
  kLetterbox,  // scaled as a whole, centred, the rest padded
  kStretch,    // each side scaled by itself
};

// Where the pixels of an image lie in a network's input. Coordinates are those of pixel centres:
// (0, 0) is the centre of the top left pixel, in the image and in the input.
class ImageFit {
 public:
  // Precondition: both sizes are positive.
  ImageFit(cv::Size image, cv::Size input, FitMode mode);

  // The part of the input that shows the image.
  const cv::Rect& content() const { return content_; }

  // A point [px] of the input as a point of the image.
  cv::Point2f ToImage(cv::Point2f input) const {
    return {(input.x + 0.5f - static_cast<float>(content_.x)) * scale_x_ - 0.5f,
            (input.y + 0.5f - static_cast<float>(content_.y)) * scale_y_ - 0.5f};
  }

  // Image pixels per input pixel.
  float scale_x() const { return scale_x_; }
  float scale_y() const { return scale_y_; }

 private:
  cv::Rect content_;
  float scale_x_;
  float scale_y_;
};

}  // namespace semantic_slam
