#include "semantic_slam/network_evaluation/segmentation_evaluation.h"

#include <cassert>

#include <opencv2/core.hpp>

#include "semantic_slam/network_evaluation/image_files.h"
#include "semantic_slam/network_evaluation/segmentation_score.h"

namespace semantic_slam {
namespace {

// The class's own label for each label id.
cv::Mat LabelsOfClasses(const cv::Mat& labels, const ClassList& classes) {
  cv::Mat table(1, 256, CV_8UC1);
  for (int id = 0; id < 256; ++id) {
    const int c = classes.of_label[id];
    table.at<LabelId>(id) = c == kIgnoredClass ? kUnknownLabel : classes.labels[c];
  }
  cv::Mat shown;
  cv::LUT(labels, table, shown);
  return shown;
}

Segmentation TimedSegment(Segmenter& segmenter, const cv::Mat& colour, StageTimer& timer) {
  const StageTimer::Scope scope(timer, "segmentation");
  return segmenter.Segment(colour, ColourOrder::kBgr, Stamp{});
}

}  // namespace

SegmentationEvaluation EvaluateSegmentation(const std::vector<LabelledImage>& images,
                                            const ClassList& classes, Segmenter& segmenter,
                                            const std::function<void(std::size_t)>& progress) {
  SegmentationEvaluation evaluation(classes.size());
  StageTimer timer;
  assert(!images.empty());
  for (const LabelledImage& image : images) {
    const cv::Mat colour = ReadColourImage(image.image_path);
    const cv::Mat truth = ReadLabelImage(image.labels_path, colour.size());
    const Segmentation predicted = TimedSegment(segmenter, colour, timer);
    ConfusionMatrix matrix(classes.size());
    CountPixels(truth, predicted.labels[0], classes, matrix);
    evaluation.confusion.Add(matrix);
    evaluation.image_accuracies.push_back(PixelAccuracy(matrix));
    progress(evaluation.image_accuracies.size());
  }
  evaluation.timing = timer.Timings().front();
  return evaluation;
}

SegmentationExample MakeExample(const LabelledImage& image, const ClassList& classes,
                                Segmenter& segmenter) {
  SegmentationExample example;
  example.colour = ReadColourImage(image.image_path);
  example.predicted = segmenter.Segment(example.colour, ColourOrder::kBgr, Stamp{});
  const cv::Mat truth = ReadLabelImage(image.labels_path, example.colour.size());
  example.truth =
      SureSegmentation(LabelsOfClasses(truth, classes), Stamp{}, example.predicted.vocabulary_hash);
  example.predicted.labels[0] = LabelsOfClasses(example.predicted.labels[0], classes);
  return example;
}

}  // namespace semantic_slam
