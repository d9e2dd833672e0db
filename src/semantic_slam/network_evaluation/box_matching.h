#pragma once

#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/network_evaluation/confusion_matrix.h"

namespace semantic_slam {

// A true or found box of one of the classes that count.
struct ClassBox {
  int class_index = 0;
  float confidence = 1.0f;
  cv::Rect2f box;
};

// Which true box each found one takes, in their order: of those that no one before has taken the
// one that it overlaps most, if their intersection over union is at least `min_iou`; else -1. Of
// equal overlaps the first. Classes do not matter.
std::vector<int> MatchInOrder(const std::vector<cv::Rect2f>& truth,
                              const std::vector<cv::Rect2f>& found, double min_iou);

// `found` without the boxes that overlap one of the `optional` ones by at least `min_iou`, and any
// true one less: they show an object that may be found or not.
std::vector<ClassBox> PassOverOptional(const std::vector<ClassBox>& truth,
                                       const std::vector<cv::Rect2f>& optional,
                                       const std::vector<ClassBox>& found, double min_iou);

// Adds an image to the confusion matrix of boxes. Pairs that overlap by at least `min_iou` are made
// one to one, those of one class before the others, the larger overlap first; what remains is
// background (none()) that was found, or true boxes taken for background.
void CountBoxes(const std::vector<ClassBox>& truth, const std::vector<ClassBox>& found,
                double min_iou, ConfusionMatrix& matrix);

}  // namespace semantic_slam
