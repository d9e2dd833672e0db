#include "semantic_slam/network_evaluation/detection_evaluation.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "semantic_slam/common/error.h"
#include "semantic_slam/detection/non_maximum_suppression.h"
#include "semantic_slam/dnn/image_fit.h"
#include "semantic_slam/network_evaluation/box_file.h"
#include "semantic_slam/network_evaluation/image_files.h"

namespace semantic_slam {
namespace {

LabelId LabelOfNumber(const BoxedImage& image, int number) {
  const std::vector<LabelId>& labels = *image.label_of_class;
  if (number >= 0 && number < static_cast<int>(labels.size())) return labels[number];
  throw InputError(image.boxes_path + ": class " + std::to_string(number) + ", expected 0 to " +
                   std::to_string(labels.size() - 1));
}

std::vector<ClassBox> AtLeast(double confidence, const std::vector<ClassBox>& boxes) {
  std::vector<ClassBox> kept;
  std::copy_if(boxes.begin(), boxes.end(), std::back_inserter(kept), [&](const ClassBox& box) {
    return static_cast<double>(box.confidence) >= confidence;
  });
  return kept;
}

Detections TimedDetect(Detector& detector, const cv::Mat& colour, StageTimer& timer) {
  const StageTimer::Scope scope(timer, "detection");
  return detector.Detect(colour, ColourOrder::kBgr, Stamp{});
}

}  // namespace

DetectorOptions OptionsForEvaluation(double max_overlap) {
  DetectorOptions options;
  options.min_confidence = 0.001;
  options.max_detections = 300;
  options.max_overlap = max_overlap;
  return options;
}

ImageTruth BoxCounting::ReadTruth(const BoxedImage& image, cv::Size size) const {
  const ImageFit fit(size, input_.size(), input_.fit);
  ImageTruth truth;
  for (const FileBox& box : ReadBoxFile(image.boxes_path, size)) {
    const LabelId label = LabelOfNumber(image, box.class_number);
    const int c = classes_.of_label[label];
    const float side = std::min(box.box.width / fit.scale_x(), box.box.height / fit.scale_y());
    if (side < kLeastSidePx) continue;
    const bool is_hidden = box.visible_share < classes_.least_visible_share;
    if (classes_.is_optional[label] || (c != kIgnoredClass && is_hidden)) {
      truth.optional.push_back(box.box);
    } else if (c != kIgnoredClass) {
      truth.boxes.push_back({c, 1.0f, box.box});
    }
  }
  return truth;
}

std::vector<ClassBox> BoxCounting::FoundBoxes(const std::vector<DetectedBox>& boxes) const {
  std::vector<ClassBox> counted;
  std::vector<ScoredBox> scored;
  for (const DetectedBox& box : boxes) {
    const int c = classes_.of_label[box.label];
    if (c == kIgnoredClass) continue;
    counted.push_back({c, box.confidence, box.box});
    scored.push_back({box.box, box.confidence, c});
  }
  std::vector<ClassBox> kept;
  for (const int i : SuppressNonMaxima(scored, max_overlap_)) kept.push_back(counted[i]);
  return kept;
}

Detections BoxCounting::ToDetections(const std::vector<ClassBox>& boxes, double threshold,
                                     cv::Size size, std::uint64_t vocabulary_hash) const {
  Detections detections;
  detections.vocabulary_hash = vocabulary_hash;
  detections.image_size = size;
  for (const ClassBox& box : AtLeast(threshold, boxes)) {
    detections.boxes.push_back({classes_.labels[box.class_index], box.confidence, box.box});
  }
  return detections;
}

DetectionEvaluation EvaluateDetection(const std::vector<BoxedImage>& images,
                                      const BoxCounting& counting, std::size_t classes,
                                      double threshold, Detector& detector,
                                      const std::function<void(std::size_t)>& progress) {
  assert(!images.empty());
  DetectionEvaluation evaluation(classes, threshold);
  StageTimer timer;
  for (const BoxedImage& image : images) {
    const cv::Mat colour = ReadColourImage(image.image_path);
    const ImageTruth truth = counting.ReadTruth(image, colour.size());
    const Detections detections = TimedDetect(detector, colour, timer);
    const std::vector<ClassBox> found = PassOverOptional(
        truth.boxes, truth.optional, counting.FoundBoxes(detections.boxes), kMatchIou);
    evaluation.image_f1s.push_back(evaluation.score.Add(truth.boxes, found).f1());
    CountBoxes(truth.boxes, AtLeast(threshold, found), kMatchIou, evaluation.confusion);
    progress(evaluation.image_f1s.size());
  }
  evaluation.timing = timer.Timings().front();
  return evaluation;
}

}  // namespace semantic_slam
