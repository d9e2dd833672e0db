#include "semantic_slam/network_evaluation/segmentation_score.h"

#include <array>
#include <cassert>
#include <limits>

#include "semantic_slam/network_evaluation/share.h"

namespace semantic_slam {
namespace {

std::int64_t CountedPixels(const ConfusionMatrix& matrix) {
  std::int64_t pixels = 0;
  for (int c = 0; c < matrix.classes(); ++c) pixels += matrix.TruthCount(c);
  return pixels;
}

ClassSegmentationScore ScoreClass(const ConfusionMatrix& matrix, int c, std::int64_t pixels) {
  const std::int64_t right = matrix.count(c, c);
  const std::int64_t truth = matrix.TruthCount(c);
  const std::int64_t predicted = matrix.PredictedCount(c);
  return {ShareOf(right, truth + predicted - right), ShareOf(right, predicted),
          ShareOf(right, truth), ShareOf(truth, pixels)};
}

}  // namespace

void CountPixels(const cv::Mat& truth, const cv::Mat& predicted, const ClassList& classes,
                 ConfusionMatrix& matrix) {
  assert(truth.type() == CV_8UC1 && predicted.type() == CV_8UC1);
  assert(truth.size() == predicted.size());
  for (int v = 0; v < truth.rows; ++v) {
    const auto* true_row = truth.ptr<LabelId>(v);
    const auto* predicted_row = predicted.ptr<LabelId>(v);
    for (int u = 0; u < truth.cols; ++u) {
      const int true_class = classes.of_label[true_row[u]];
      if (true_class == kIgnoredClass) continue;
      const int predicted_class = classes.of_label[predicted_row[u]];
      matrix.Add(true_class, predicted_class == kIgnoredClass ? matrix.none() : predicted_class);
    }
  }
}

SegmentationScore ScoreSegmentation(const ConfusionMatrix& matrix) {
  SegmentationScore score;
  score.pixels = CountedPixels(matrix);
  score.pixel_accuracy = PixelAccuracy(matrix);
  int present = 0;
  for (int c = 0; c < matrix.classes(); ++c) {
    const ClassSegmentationScore of_class = ScoreClass(matrix, c, score.pixels);
    score.classes.push_back(of_class);
    if (matrix.TruthCount(c) == 0) continue;
    ++present;
    score.mean_class_accuracy += of_class.recall;
    score.mean_iou += of_class.iou;
    score.frequency_weighted_iou += of_class.pixel_share * of_class.iou;
  }
  score.mean_class_accuracy /= present;  // 0 / 0 is NaN, as it should be
  score.mean_iou /= present;
  if (present == 0) score.frequency_weighted_iou = std::numeric_limits<double>::quiet_NaN();
  return score;
}

double PixelAccuracy(const ConfusionMatrix& matrix) {
  std::int64_t right = 0;
  for (int c = 0; c < matrix.classes(); ++c) right += matrix.count(c, c);
  return ShareOf(right, CountedPixels(matrix));
}

}  // namespace semantic_slam
