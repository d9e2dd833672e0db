#include "semantic_slam/dnn/image_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace semantic_slam {

ImageFit::ImageFit(cv::Size image, cv::Size input, FitMode mode) : content_({0, 0}, input) {
  assert(image.width > 0 && image.height > 0 && input.width > 0 && input.height > 0);
  if (mode == FitMode::kLetterbox) {
    const double scale = std::min(static_cast<double>(input.width) / image.width,
                                  static_cast<double>(input.height) / image.height);
    const int width =
        std::clamp(static_cast<int>(std::lround(image.width * scale)), 1, input.width);
    const int height =
        std::clamp(static_cast<int>(std::lround(image.height * scale)), 1, input.height);
    content_ = {(input.width - width) / 2, (input.height - height) / 2, width, height};
  }
  scale_x_ = static_cast<float>(image.width) / static_cast<float>(content_.width);
  scale_y_ = static_cast<float>(image.height) / static_cast<float>(content_.height);
}

}  // namespace semantic_slam
