#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/stamp.h"
#include "semantic_slam/segmentation/segmentation.h"
#include "semantic_slam/simulation/similar_labels.h"
#include "semantic_slam/worlds/world.h"

namespace semantic_slam {

struct LabelErrorOptions {
  double unknown_probability = 0.02;    // that a thing passes for nothing known,
  double confusion_probability = 0.08;  // and if not, that it passes for one of a similar class
  double period_s = 1.5;                // for which a thing is seen in the same way
  double border_wobble_px = 1.5;        // standard deviation of where a border is seen
  double mean_confidence = 0.8;         // of the first label, where it is right
  double confidence_spread = 0.1;       // standard deviation of it
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("unknown_probability", self.unknown_probability, 0.0, 1.0);
    visit("confusion_probability", self.confusion_probability, 0.0, 1.0);
    visit("period_s", self.period_s, 0.01, 3600.0);
    visit("border_wobble_px", self.border_wobble_px, 0.0, 100.0);
    visit("mean_confidence", self.mean_confidence, 0.4, 1.0);
    visit("confidence_spread", self.confidence_spread, 0.0, 0.5);
    visit("seed", self.seed, 0, 1000000);
  }
};

// Stands in for a segmentation network: makes of true labels what a network with stated error rates
// would make of the image. Errors hit whole things for a while, as a network's do, not single
// pixels; so maps must outvote them from other views. Where a border is seen wobbles from image to
// image. The same seed, image and stamp give the same bytes. Immutable, so safe from any thread.
class LabelErrors {
 public:
  // Throws ConfigError if an option is out of range.
  LabelErrors(const LabelErrorOptions& options, const LabelVocabulary& vocabulary);

  // `labels` and `instances` are those of a RenderedView. Precondition: they are of one size, not
  // empty, CV_8UC1 and CV_16UC1, and the labels are the vocabulary's.
  Segmentation Apply(const cv::Mat& labels, const cv::Mat& instances, Stamp stamp) const;

 private:
  // What a network says of a pixel.
  struct Opinion {
    std::array<LabelId, kTopLabels> labels{};
    std::array<std::uint8_t, kTopLabels> confidences{};
  };

  std::vector<Opinion> OpinionsOnInstances(const cv::Mat& labels, const cv::Mat& instances,
                                           Stamp stamp) const;
  Opinion OpinionOn(InstanceId instance, LabelId label, Stamp stamp) const;
  Opinion Ranked(LabelId first, double confidence, const std::vector<LabelId>& others) const;
  cv::Mat Wobbled(const cv::Mat& instances, Stamp stamp) const;

  const LabelErrorOptions options_;
  const std::uint64_t vocabulary_hash_;
  const SimilarLabels similar_;
};

}  // namespace semantic_slam
