#pragma once

#include <opencv2/core.hpp>

#include "semantic_slam/camera/rgbd_image.h"
#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/detection/detections.h"

namespace semantic_slam {

// A copy of `colour` (CV_8UC3) for people to look at, with the boxes in the colours of their
// labels, the surest on top, each with its label's name and confidence. Throws InputError if the
// image is of another type or the detections are not of the vocabulary.
cv::Mat DrawDetections(const cv::Mat& colour, ColourOrder order, const Detections& detections,
                       const LabelVocabulary& vocabulary);

}  // namespace semantic_slam
