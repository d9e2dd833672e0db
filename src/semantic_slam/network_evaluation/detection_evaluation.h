#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "semantic_slam/common/class_list.h"
#include "semantic_slam/common/duration_histogram.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/detection/detector.h"
#include "semantic_slam/dnn/model_card.h"
#include "semantic_slam/network_evaluation/boxed_images.h"
#include "semantic_slam/network_evaluation/confusion_matrix.h"
#include "semantic_slam/network_evaluation/detection_score.h"

namespace semantic_slam {

// True boxes whose shorter side in the network's input is smaller are left out, as in training/
// [px].
constexpr float kLeastSidePx = 3.0f;

// All boxes that a detector can give, however unsure: average precision needs them.
DetectorOptions OptionsForEvaluation(double max_overlap);

// What a detection network did on a set of images.
struct DetectionEvaluation {
  DetectionEvaluation(std::size_t classes, double threshold)
      : score(classes, threshold), confusion(classes) {}

  DetectionScore score;
  ConfusionMatrix confusion;      // of boxes at the threshold and IoU 0.5; none() is background
  std::vector<double> image_f1s;  // at the threshold; NaN where nothing is true nor found
  StageTiming timing;             // per image, without reading it
};

// What there is in an image.
struct ImageTruth {
  std::vector<ClassBox> boxes;
  std::vector<cv::Rect2f> optional;  // of objects that may be found or not
};

// How truth and findings of an image are counted. Immutable, so safe from any thread; what it is
// made of must outlive it.
class BoxCounting {
 public:
  BoxCounting(const ClassList& classes, const NetworkInput& input, double max_overlap)
      : classes_(classes), input_(input), max_overlap_(max_overlap) {}

  // The boxes of classes that count and are not too small, and those of what may be found or not.
  // Throws InputError naming a file that is not understood or speaks of a class that there is not.
  ImageTruth ReadTruth(const BoxedImage& image, cv::Size size) const;

  // The boxes of classes that count of what was found; where boxes of labels that count as one
  // class overlap too much, the surest stays, as the detector has it within a label.
  std::vector<ClassBox> FoundBoxes(const std::vector<DetectedBox>& boxes) const;

  // For pictures: the boxes from `threshold` on, by the labels that the classes are named after.
  Detections ToDetections(const std::vector<ClassBox>& boxes, double threshold, cv::Size size,
                          std::uint64_t vocabulary_hash) const;

 private:
  const ClassList& classes_;
  const NetworkInput& input_;
  const double max_overlap_;
};

// Reads one image after another and looks for objects. Precondition: there are images; `progress`
// hears how many are done. Throws InputError naming a file that is missing or damaged.
DetectionEvaluation EvaluateDetection(const std::vector<BoxedImage>& images,
                                      const BoxCounting& counting, std::size_t classes,
                                      double threshold, Detector& detector,
                                      const std::function<void(std::size_t)>& progress);

}  // namespace semantic_slam
