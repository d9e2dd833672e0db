#pragma once

#include <opencv2/core.hpp>

namespace semantic_slam {

// A box as a network gives it. Unlike everywhere else, (0, 0) is the corner of the top left pixel
// here, not its centre: networks are trained so.
struct NetworkBox {
  int class_index = 0;      // in the order of the model's classes
  float confidence = 0.0f;  // 0..1
  cv::Rect2f box;           // [px] of the network's input
};

}  // namespace semantic_slam
