#include "semantic_slam/segmentation/segmentation.h"

#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/common/label_check.h"

namespace semantic_slam {
namespace {

void CheckPlane(const cv::Mat& plane, const cv::Size& size, const char* what, int index) {
  if (plane.type() == CV_8UC1 && plane.size() == size) return;
  throw InputError("segmentation: " + std::string(what) + " plane " + std::to_string(index) +
                   " is " + cv::typeToString(plane.type()) + " of " + std::to_string(plane.cols) +
                   " x " + std::to_string(plane.rows) + " px, expected CV_8UC1 of " +
                   std::to_string(size.width) + " x " + std::to_string(size.height));
}

void CheckLabels(const cv::Mat& plane, const LabelVocabulary& vocabulary) {
  for (int v = 0; v < plane.rows; ++v) {
    const auto* row = plane.ptr<LabelId>(v);
    for (int u = 0; u < plane.cols; ++u) {
      if (vocabulary.Contains(row[u])) continue;
      throw InputError("segmentation: label id " + std::to_string(row[u]) + " at pixel (" +
                       std::to_string(u) + ", " + std::to_string(v) + ") is not in the vocabulary");
    }
  }
}

}  // namespace

Segmentation SureSegmentation(const cv::Mat& labels, Stamp stamp, std::uint64_t vocabulary_hash) {
  Segmentation segmentation;
  segmentation.stamp = stamp;
  segmentation.vocabulary_hash = vocabulary_hash;
  const cv::Mat none = cv::Mat::zeros(labels.size(), CV_8UC1);
  segmentation.labels = {labels, none, none};
  segmentation.confidences = {cv::Mat(labels.size(), CV_8UC1, cv::Scalar(255)), none, none};
  return segmentation;
}

void CheckSegmentation(const Segmentation& segmentation, const LabelVocabulary& vocabulary) {
  CheckLabelSet("segmentation", segmentation.vocabulary_hash, vocabulary);
  if (segmentation.labels[0].empty()) throw InputError("segmentation: has no pixels");
  for (int i = 0; i < kTopLabels; ++i) {
    CheckPlane(segmentation.labels[i], segmentation.size(), "label", i);
    CheckPlane(segmentation.confidences[i], segmentation.size(), "confidence", i);
    CheckLabels(segmentation.labels[i], vocabulary);
  }
}

}  // namespace semantic_slam
