#pragma once

#include <optional>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/dnn/model.h"
#include "semantic_slam/dnn/network.h"
#include "semantic_slam/segmentation/label_probabilities.h"
#include "semantic_slam/segmentation/label_upsampling.h"
#include "semantic_slam/segmentation/segmentation.h"

namespace semantic_slam {

// Labels every pixel of colour images with a segmentation network (thesis section 3.3.1): any that
// gives 1 x K x h x w scores of K classes. Not thread-safe: one thread at a time.
class Segmenter {
 public:
  // Throws ConfigError if the card is not one of segmentation, the network cannot be run or does
  // not give what the card says, or the classes do not map to the vocabulary.
  Segmenter(const Model& model, const LabelVocabulary& vocabulary, const NetworkOptions& options);

  // The labels of `colour` (CV_8UC3, raw pixels), at its size. Throws InputError if it is empty or
  // of another type.
  Segmentation Segment(const cv::Mat& colour, ColourOrder order, Stamp stamp);

 private:
  void FollowSize(cv::Size image);

  Network network_;
  ClassScores scores_;
  const cv::Size input_;
  const cv::Size cells_;  // of the network's output
  const std::uint64_t vocabulary_hash_;
  cv::Size image_;  // that upsampler_ is for
  std::optional<LabelUpsampler> upsampler_;
};

}  // namespace semantic_slam
