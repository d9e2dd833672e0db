#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"

namespace semantic_slam {

// An object in one image. The box is in raw pixels; (0, 0) is the centre of the top left pixel.
struct DetectedBox {
  LabelId label = kUnknownLabel;
  float confidence = 0.0f;  // 0..1
  cv::Rect2f box;           // x, y: left and top edge [px]; width and height [px], positive
};

// The objects that a detector found in one colour image.
struct Detections {
  Stamp stamp;  // the colour image's
  std::uint64_t vocabulary_hash = 0;
  cv::Size image_size;             // [px]
  std::vector<DetectedBox> boxes;  // by descending confidence
};

// Throws InputError, naming what is wrong, if the hash is not the vocabulary's, a label id is not
// in it, or a confidence or box is not finite or out of range. Boxes may reach beyond the image.
void CheckDetections(const Detections& detections, const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
