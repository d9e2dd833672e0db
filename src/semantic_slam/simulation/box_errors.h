#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "semantic_slam/common/label_vocabulary.h"
#include "semantic_slam/common/random_stream.h"
#include "semantic_slam/detection/detections.h"
#include "semantic_slam/simulation/similar_labels.h"

namespace semantic_slam {

struct BoxErrorOptions {
  double miss_probability = 0.1;           // of each true box
  double false_positives_per_image = 0.1;  // mean number of boxes around nothing
  double confusion_probability = 0.05;     // of each true box, with a similar class
  double jitter_px = 1.0;                  // standard deviation of each edge [px],
  double jitter_share = 0.02;              // and as a share of the box's width or height
  double mean_confidence = 0.75;
  double confidence_spread = 0.12;  // standard deviation of it
  int seed = 1;

  template <typename Self, typename Visitor>
  static void Visit(Self& self, Visitor&& visit) {
    visit("miss_probability", self.miss_probability, 0.0, 1.0);
    visit("false_positives_per_image", self.false_positives_per_image, 0.0, 20.0);
    visit("confusion_probability", self.confusion_probability, 0.0, 1.0);
    visit("jitter_px", self.jitter_px, 0.0, 100.0);
    visit("jitter_share", self.jitter_share, 0.0, 0.5);
    visit("mean_confidence", self.mean_confidence, 0.01, 1.0);
    visit("confidence_spread", self.confidence_spread, 0.0, 0.5);
    visit("seed", self.seed, 0, 1000000);
  }
};

// Stands in for a detection network: makes of the true boxes in an image what a network with stated
// error rates would find. The same seed, boxes and stamp give the same detections. Immutable, so
// safe from any thread.
class BoxErrors {
 public:
  // Throws ConfigError if an option is out of range.
  BoxErrors(const BoxErrorOptions& options, const LabelVocabulary& vocabulary);

  // `truth` holds every object in view; its confidences are not looked at.
  Detections Apply(const Detections& truth) const;

 private:
  std::optional<DetectedBox> Detect(const DetectedBox& truth, cv::Size image_size,
                                    RandomStream& random) const;
  DetectedBox Invent(cv::Size image_size, RandomStream& random) const;
  float DrawConfidence(double mean, RandomStream& random) const;

  const BoxErrorOptions options_;
  const SimilarLabels similar_;
  std::vector<LabelId> inventable_;  // what may be seen where there is nothing
};

}  // namespace semantic_slam
