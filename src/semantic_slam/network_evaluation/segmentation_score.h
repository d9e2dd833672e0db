#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/network_evaluation/confusion_matrix.h"

namespace semantic_slam {

// Shares, 0..1. NaN where nothing was there to be counted.
struct ClassSegmentationScore {
  double iou = 0.0;          // intersection over union; NaN if neither true nor predicted anywhere
  double precision = 0.0;    // thesis eq. (4.8), of pixels
  double recall = 0.0;       // the same; also called class accuracy
  double pixel_share = 0.0;  // of the pixels that count, how many truly are of the class
};

// How well pixels were labelled. Means are over the classes that occur in the truth; all are NaN
// without any pixel.
struct SegmentationScore {
  std::int64_t pixels = 0;      // that count
  double pixel_accuracy = 0.0;  // share of them that have the right class, as in thesis Fig. 4.6
  double mean_class_accuracy = 0.0;
  double mean_iou = 0.0;
  double frequency_weighted_iou = 0.0;  // each class by its share of the pixels
  std::vector<ClassSegmentationScore> classes;
};

// Adds an image's pixels. Those whose true label is ignored do not count; a predicted label that is
// none of the classes is a miss. Precondition: both are CV_8UC1 label ids of one size.
void CountPixels(const cv::Mat& truth, const cv::Mat& predicted, const ClassList& classes,
                 ConfusionMatrix& matrix);

SegmentationScore ScoreSegmentation(const ConfusionMatrix& matrix);

// Share of the counted pixels that have the right class, NaN without any.
double PixelAccuracy(const ConfusionMatrix& matrix);

}  // namespace semantic_slam
