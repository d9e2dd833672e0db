#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/network_evaluation/confusion_matrix.h"
#include "semantic_slam/network_evaluation/labelled_images.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam/segmentation/segmenter.h"

namespace semantic_slam {

// What a segmentation network did on a set of images.
struct SegmentationEvaluation {
  explicit SegmentationEvaluation(std::size_t classes) : confusion(classes) {}

  ConfusionMatrix confusion;             // of pixels
  std::vector<double> image_accuracies;  // pixel accuracy of each image; NaN if no pixel counts
  StageTiming timing;                    // per image, without reading it
};

// Reads and segments one image after another; `progress` hears how many are done. Precondition:
// there are images. Throws InputError naming a file that is missing or damaged.
SegmentationEvaluation EvaluateSegmentation(const std::vector<LabelledImage>& images,
                                            const ClassList& classes, Segmenter& segmenter,
                                            const std::function<void(std::size_t)>& progress);

// What is shown of one image.
struct SegmentationExample {
  cv::Mat colour;  // BGR
  Segmentation truth;
  Segmentation predicted;
};

// Both with the labels that the classes are named after, and unknown for what counts as none.
SegmentationExample MakeExample(const LabelledImage& image, const ClassList& classes,
                                Segmenter& segmenter);

}  // namespace semantic_slam
