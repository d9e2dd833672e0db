#pragma once

#include <cstddef>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/dnn/model_card.h"

namespace semantic_slam {

// The probability of every label in every cell of a network's output.
struct LabelProbabilities {
  std::vector<LabelId> labels;  // ascending
  int width = 0;                // cells
  int height = 0;
  std::vector<float> values;  // cell by cell, row-major; within a cell in the order of `labels`

  const float* Cell(int x, int y) const {
    return &values[(static_cast<std::size_t>(y) * width + x) * labels.size()];
  }
};

// Makes label probabilities of a network's class scores: softmax over the classes (thesis
// eq. 3.15), then the sum over the classes of one label. Not thread-safe: it keeps its buffers.
class ClassScores {
 public:
  // `class_labels` has the label of each class. Labels that no class has are added, with
  // probability 0, so that there are at least kTopLabels and unknown is among them. Throws
  // ConfigError if the vocabulary has fewer. Precondition: `activation` is kSoftmax or, for scores
  // that are probabilities already, kNone.
  ClassScores(const std::vector<LabelId>& class_labels, const LabelVocabulary& vocabulary,
              Activation activation);

  // `scores` is 1 x K x h x w, CV_32F. A cell in which a score is not finite says unknown. Valid
  // until the next call.
  const LabelProbabilities& ToProbabilities(const cv::Mat& scores);

 private:
  void FillRow(const cv::Mat& scores, int y);
  // The exponentials of `scores_`, in place, and their `factors_`.
  void Softmax(int width);
  void Clamp();
  void AddToLabels(int width, float* cells) const;
  void MarkFaultsUnknown(int width, float* cells) const;

  const Activation activation_;
  std::vector<int> columns_;    // of each class: where its label stands among the labels
  std::vector<float> scores_;   // one row of cells, class by class
  std::vector<float> maxima_;   // per cell of that row
  std::vector<float> factors_;  // per cell of that row: 1 over the sum
  std::vector<float> faults_;   // per cell of that row: 0 if all scores are finite, else NaN
  LabelProbabilities probabilities_;
};

}  // namespace semantic_slam
