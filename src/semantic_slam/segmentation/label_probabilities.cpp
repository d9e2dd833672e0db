#include "semantic_slam/segmentation/label_probabilities.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "semantic_slam/common/error.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {
namespace {

// The labels of the classes and of as many others as it takes, ascending.
std::vector<LabelId> DistinctLabels(const std::vector<LabelId>& class_labels,
                                    const LabelVocabulary& vocabulary) {
  std::vector<LabelId> labels = class_labels;
  labels.push_back(kUnknownLabel);
  const auto make_distinct = [&labels] {
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  };
  make_distinct();
  for (const LabelClass& label : vocabulary.classes()) {
    if (labels.size() >= static_cast<std::size_t>(kTopLabels)) break;
    labels.push_back(label.id);
    make_distinct();
  }
  if (labels.size() < static_cast<std::size_t>(kTopLabels)) {
    throw ConfigError("labels: the vocabulary has " + std::to_string(labels.size()) +
                      " classes, expected at least " + std::to_string(kTopLabels));
  }
  return labels;
}

}  // namespace

ClassScores::ClassScores(const std::vector<LabelId>& class_labels,
                         const LabelVocabulary& vocabulary, Activation activation)
    : activation_(activation) {
  assert(activation == Activation::kSoftmax || activation == Activation::kNone);
  probabilities_.labels = DistinctLabels(class_labels, vocabulary);
  const std::vector<LabelId>& labels = probabilities_.labels;
  for (const LabelId label : class_labels) {
    const auto at = std::lower_bound(labels.begin(), labels.end(), label);
    columns_.push_back(static_cast<int>(at - labels.begin()));
  }
}

const LabelProbabilities& ClassScores::ToProbabilities(const cv::Mat& scores) {
  assert(scores.dims == 4 && scores.size[1] == static_cast<int>(columns_.size()) &&
         scores.type() == CV_32F);
  const int width = scores.size[3];
  probabilities_.height = scores.size[2];
  probabilities_.width = width;
  probabilities_.values.assign(
      static_cast<std::size_t>(probabilities_.height) * width * probabilities_.labels.size(), 0.0f);
  scores_.resize(columns_.size() * width);
  maxima_.resize(width);
  factors_.resize(width);
  faults_.resize(width);
  const std::size_t row_values = width * probabilities_.labels.size();
  for (int y = 0; y < probabilities_.height; ++y) {
    float* cells = &probabilities_.values[y * row_values];
    FillRow(scores, y);
    activation_ == Activation::kSoftmax ? Softmax(width) : Clamp();
    AddToLabels(width, cells);
    MarkFaultsUnknown(width, cells);
  }
  return probabilities_;
}

void ClassScores::FillRow(const cv::Mat& scores, int y) {
  const int width = scores.size[3];
  std::fill(faults_.begin(), faults_.end(), 0.0f);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const float* row = scores.ptr<float>(0, static_cast<int>(k), y);
    std::copy(row, row + width, &scores_[k * width]);
    for (int x = 0; x < width; ++x) faults_[x] += 0.0f * row[x];
  }
}

void ClassScores::Softmax(int width) {
  std::copy_n(scores_.begin(), width, maxima_.begin());
  for (std::size_t k = 1; k < columns_.size(); ++k) {
    const float* row = &scores_[k * width];
    for (int x = 0; x < width; ++x) maxima_[x] = row[x] > maxima_[x] ? row[x] : maxima_[x];
  }
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    float* row = &scores_[k * width];
    for (int x = 0; x < width; ++x) row[x] -= maxima_[x];
  }
  cv::exp(scores_, scores_);
  std::fill(factors_.begin(), factors_.end(), 0.0f);
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const float* row = &scores_[k * width];
    for (int x = 0; x < width; ++x) factors_[x] += row[x];
  }
  for (float& factor : factors_) factor = 1.0f / factor;
}

void ClassScores::Clamp() {
  std::fill(factors_.begin(), factors_.end(), 1.0f);
  for (float& score : scores_) score = std::clamp(score, 0.0f, 1.0f);
}

void ClassScores::AddToLabels(int width, float* cells) const {
  const std::size_t labels = probabilities_.labels.size();
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    const float* row = &scores_[k * width];
    float* value = cells + columns_[k];
    for (int x = 0; x < width; ++x, value += labels) *value += row[x] * factors_[x];
  }
}

void ClassScores::MarkFaultsUnknown(int width, float* cells) const {
  const std::size_t labels = probabilities_.labels.size();
  for (int x = 0; x < width; ++x, cells += labels) {
    if (faults_[x] == 0.0f) continue;
    std::fill(cells, cells + labels, 0.0f);
    cells[0] = 1.0f;  // kUnknownLabel is the lowest id
  }
}

}  // namespace semantic_slam
